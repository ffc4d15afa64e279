// Makes text of unknown origin safe to print. Knows bytes only.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace isl::cli {

/// The length in bytes of the UTF-8 character at `at` (within the text): 1 to 4, or 0 if none begins there.
[[nodiscard]] inline std::size_t character_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[at + i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || at + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0u) != 0x80u) return 0;
  }
  // Invalid: longer than needed, halves of surrogate pairs, and beyond the last code point.
  const unsigned char second = byte(1);
  const bool is_wrong = (first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0) ||
                        (first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90);
  return is_wrong ? 0 : length;
}

/// True for C0 and C1 controls and DEL, which a terminal would obey; tab and line feed do not count here.
[[nodiscard]] inline bool is_control(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  if (character.size() == 1) return (first < 0x20 && first != '\t' && first != '\n') || first == 0x7F;
  return first == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0;
}

/// Valid UTF-8 without control characters; each offender becomes U+FFFD.
[[nodiscard]] inline std::string printable(std::string_view text) {
  static constexpr std::string_view kReplacement = "\xEF\xBF\xBD";
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_length(text, at);
    const std::string_view character = text.substr(at, length == 0 ? 1 : length);
    result += length == 0 || is_control(character) ? kReplacement : character;
    at += character.size();
  }
  return result;
}

/// The text with control characters, and bytes that are not UTF-8, written as `\x1b`: visible, and without effect on a
/// terminal.
[[nodiscard]] inline std::string with_visible_controls(std::string_view text) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_length(text, at);
    const std::string_view character = text.substr(at, length == 0 ? 1 : length);
    at += character.size();
    if (length != 0 && !is_control(character)) {
      result += character;
      continue;
    }
    // C1 controls have two bytes in UTF-8, the second of which is the code.
    const auto code = static_cast<unsigned char>(character.back());
    result += "\\x";
    result += kDigits[code >> 4];
    result += kDigits[code & 15];
  }
  return result;
}

}  // namespace isl::cli
