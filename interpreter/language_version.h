// The language version of a scene: two things that `#version` sets. The value of the word `version` decides how the
// following text is parsed; whether any file states a version at all decides, at the end, how light is encoded.
#pragma once

#include <cmath>

namespace isl::interpreter {

class LanguageVersion {
 public:
  /// The newest version that is known: the value of `version` if none is stated, in POV-Ray too.
  static constexpr double kNewest = 3.7;

  /// `is_stated`: the scene counts as one that states the newest version, as our own files do.
  explicit LanguageVersion(bool is_stated) : is_stated_(is_stated) {}

  /// As in POV-Ray, a version has two decimals; more are rounded.
  void state(double version) {
    number_ = std::trunc(version * 100 + 0.5) / 100;
    is_stated_ = true;
  }

  /// The value of the word `version`.
  [[nodiscard]] double number() const { return number_; }

  /// The version whose defaults the scene gets. POV-Ray takes a scene without any `#version` for an old one, although
  /// `version` reads 3.7 there.
  [[nodiscard]] double of_defaults() const {
    constexpr double kUnstated = 3.62;
    return is_stated_ ? number_ : kUnstated;
  }

 private:
  double number_ = kNewest;
  bool is_stated_;
};

}  // namespace isl::interpreter
