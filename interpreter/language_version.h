// The version of the language that a scene is written in: two things that `#version` sets. What the word `version`
// reads decides how text is parsed from there on; that any file stated one at all decides, at the end, how light is
// encoded.
#pragma once

#include <cmath>

namespace isl::interpreter {

class LanguageVersion {
 public:
  /// The newest version that is known: what `version` reads where nothing is stated, in POV-Ray too.
  static constexpr double kNewest = 3.7;

  /// `is_stated`: the scene counts as one that states the newest version, as files of our own kind do.
  explicit LanguageVersion(bool is_stated) : is_stated_(is_stated) {}

  /// As in POV-Ray, a version has two decimals; more are rounded.
  void state(double version) {
    number_ = std::trunc(version * 100 + 0.5) / 100;
    is_stated_ = true;
  }

  /// What the word `version` reads.
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
