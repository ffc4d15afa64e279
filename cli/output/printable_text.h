// Makes text of unknown origin safe to print: a terminal shows it and obeys none of it. Knows bytes only.
#pragma once

#include <cstddef>
#include <cstdint>
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

/// The code point of one UTF-8 character.
[[nodiscard]] inline std::uint32_t code_point(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  if (character.size() == 1) return first;
  std::uint32_t code = first & (0x7Fu >> character.size());
  for (const char c : character.substr(1)) code = code << 6 | (static_cast<unsigned char>(c) & 0x3Fu);
  return code;
}

/// True for what a terminal obeys instead of showing it: C0 and C1 controls, DEL, and the marks, embeddings, overrides
/// and isolates of bidirectional text (Unicode, UAX #9), which make a line read other than it is. Tab and line feed do
/// not count here.
[[nodiscard]] inline bool is_control(std::uint32_t code) {
  if (code < 0x20) return code != '\t' && code != '\n';
  return (code >= 0x7F && code <= 0x9F) || code == 0x061C || code == 0x200E || code == 0x200F ||
         (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

/// `replaced(character, length)` makes the text for each control, whose length is that of its UTF-8, and for each byte
/// that is no UTF-8, whose length is 0. All else stays.
template <class Replace>
[[nodiscard]] std::string with_controls_replaced(std::string_view text, const Replace& replaced) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_length(text, at);
    const std::string_view character = text.substr(at, length == 0 ? 1 : length);
    at += character.size();
    if (length != 0 && !is_control(code_point(character))) {
      result += character;
    } else {
      result += replaced(character, length);
    }
  }
  return result;
}

/// `\x1b` or `\u202e`.
[[nodiscard]] inline std::string escape_of(std::uint32_t code) {
  static constexpr char kDigits[] = "0123456789abcdef";
  const int digits = code < 0x100 ? 2 : 4;
  std::string result = digits == 2 ? "\\x" : "\\u";
  for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) result += kDigits[code >> shift & 15u];
  return result;
}

/// The text with controls, and bytes that are not UTF-8, written as `\x1b` and `\u202e`.
[[nodiscard]] inline std::string with_visible_controls(std::string_view text) {
  return with_controls_replaced(text, [](std::string_view character, std::size_t length) {
    return escape_of(length == 0 ? static_cast<unsigned char>(character[0]) : code_point(character));
  });
}

/// The same for a name, which stays within its line: tabs and line feeds are written as `\x0a`, too.
[[nodiscard]] inline std::string visible_name(std::string_view name) {
  std::string result;
  for (const char c : with_visible_controls(name)) {
    if (c == '\n' || c == '\t') {
      result += escape_of(static_cast<unsigned char>(c));
    } else {
      result += c;
    }
  }
  return result;
}

/// The text of the same width: every control, and every byte that is no UTF-8, becomes U+FFFD.
[[nodiscard]] inline std::string printable(std::string_view text) {
  return with_controls_replaced(text, [](std::string_view, std::size_t) { return "\xEF\xBF\xBD"; });
}

/// The text with U+FFFD for bytes that are no UTF-8, and else unchanged.
[[nodiscard]] inline std::string valid_utf8(std::string_view text) {
  return with_controls_replaced(text, [](std::string_view character, std::size_t length) {
    return length == 0 ? std::string_view("\xEF\xBF\xBD") : character;
  });
}

/// A JSON document with the same content: controls outside ASCII, which only stand in its strings and which JSON allows
/// there, become `\u009b`.
[[nodiscard]] inline std::string json_with_visible_controls(std::string_view document) {
  return with_controls_replaced(document, [](std::string_view character, std::size_t length) {
    const std::uint32_t code = length == 0 ? 0xFFFD : code_point(character);
    return code < 0x100 ? "\\u00" + escape_of(code).substr(2) : escape_of(code);
  });
}

}  // namespace isl::cli
