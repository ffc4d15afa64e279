// The language version of a scene: two things that `#version` sets. The value of the word `version` decides how the
// following text is parsed; whether any file states a version at all decides, at the end, how light is encoded.
#pragma once

#include <cmath>

namespace isl::interpreter {

class LanguageVersion {
 public:
  /// The value of `version` if none is stated.
  static constexpr double kUnstated = 3.7;
  /// The newest version that is known. Its words are reserved in scenes that state it.
  static constexpr double kNewest = 3.8;
  /// Its words and defaults hold from here on: while 3.8 was made, it called itself 3.71.
  static constexpr double kWithNewerWords = 3.71;

  /// `is_stated`: the scene counts as one that states the newest version, as our own files do.
  explicit LanguageVersion(bool is_stated) : is_stated_(is_stated) {}

  /// As in POV-Ray, a version has two decimals; more are rounded.
  void state(double version) {
    number_ = std::trunc(version * 100 + 0.5) / 100;
    is_stated_ = true;
    has_statement_ = true;
  }

  /// True if the scene says that it is older, or is a file of POV-Ray's that says nothing.
  [[nodiscard]] bool is_stated_below(double version) const {
    const bool is_our_own = is_stated_ && !has_statement_;
    return !is_our_own && number_ < version;
  }

  /// The value of the word `version`.
  [[nodiscard]] double number() const { return number_; }

  /// The version whose defaults the scene gets. POV-Ray takes a scene without any `#version` for an old one, although
  /// `version` reads 3.7 there.
  [[nodiscard]] double of_defaults() const {
    constexpr double kOld = 3.62;
    return is_stated_ ? number_ : kOld;
  }

 private:
  double number_ = kUnstated;
  bool is_stated_;
  bool has_statement_ = false;
};

}  // namespace isl::interpreter
