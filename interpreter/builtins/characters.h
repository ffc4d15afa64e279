// Characters of UTF-8 strings: counting, cutting, comparing. A byte that belongs to no character counts as one.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace isl::interpreter {

[[nodiscard]] std::size_t character_count(std::string_view text);
/// `count` characters from number `first` (0 is the first) on; nothing if the text has fewer.
[[nodiscard]] std::optional<std::string_view> characters(std::string_view text, std::size_t first, std::size_t count);
/// The first code point; 0 for an empty text.
[[nodiscard]] char32_t first_character(std::string_view text);
/// The same, and removes it from a text that is not empty.
[[nodiscard]] char32_t take_character(std::string_view& text);
/// The character as UTF-8; empty for 0. At most 0xFFFF.
[[nodiscard]] std::string character_of(char32_t code);
/// a's code point minus b's at their first difference; the end of a text counts as 0.
[[nodiscard]] int compare_characters(std::string_view a, std::string_view b);

}  // namespace isl::interpreter
