// A short fingerprint of files for a picture's metadata: the same scene gives the same fingerprint on every machine and
// in every later version of the program. FNV-1a with 64 bits (Fowler, Noll, Vo); it is no cryptographic hash.
#pragma once

#include <cstdint>
#include <string_view>

namespace isl {

class ContentHash {
 public:
  /// Appends a text. Its end counts, so that "ab" + "c" differs from "a" + "bc".
  void add(std::string_view text) {
    for (const char c : text) mix(static_cast<unsigned char>(c));
    mix(0x100);  // no byte has this value
  }
  [[nodiscard]] std::uint64_t value() const { return state_; }

 private:
  void mix(std::uint64_t word) { state_ = (state_ ^ word) * 0x100000001B3ULL; }
  std::uint64_t state_ = 0xCBF29CE484222325ULL;
};

}  // namespace isl
