#include "interpreter/builtins/characters.h"

#include <algorithm>

namespace isl::interpreter {
namespace {

bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xC0u) == 0x80u; }

/// The bytes of the first character of a non-empty text.
std::size_t length_of_first(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t wanted = lead < 0xC0 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  std::size_t length = 1;
  while (length < wanted && length < text.size() && continues(text[length])) ++length;
  return length == wanted ? length : 1;
}

/// The byte where character number `index` begins, or the text's size if it has exactly so many characters; nothing
/// beyond.
std::optional<std::size_t> position_of(std::string_view text, std::size_t index) {
  std::size_t at = 0;
  for (; index > 0; --index) {
    if (at == text.size()) return std::nullopt;
    at += length_of_first(text.substr(at));
  }
  return at;
}

}  // namespace

std::size_t character_count(std::string_view text) {
  std::size_t count = 0;
  for (; !text.empty(); ++count) text.remove_prefix(length_of_first(text));
  return count;
}

std::optional<std::string_view> characters(std::string_view text, std::size_t first, std::size_t count) {
  const std::optional<std::size_t> begin = position_of(text, first);
  if (!begin) return std::nullopt;
  const std::string_view rest = text.substr(*begin);
  const std::optional<std::size_t> length = position_of(rest, count);
  if (!length) return std::nullopt;
  return rest.substr(0, *length);
}

char32_t first_character(std::string_view text) {
  if (text.empty()) return 0;
  const std::size_t length = length_of_first(text);
  const auto lead = static_cast<unsigned char>(text[0]);
  if (length == 1) return lead;
  char32_t code = lead & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) code = code << 6 | (static_cast<unsigned char>(text[i]) & 0x3Fu);
  return code;
}

char32_t take_character(std::string_view& text) {
  const char32_t code = first_character(text);
  text.remove_prefix(length_of_first(text));
  return code;
}

std::string character_of(char32_t code) {
  const auto byte = [](char32_t bits) { return static_cast<char>(static_cast<unsigned char>(bits)); };
  if (code == 0) return {};
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xC0 | code >> 6), byte(0x80 | (code & 0x3F))};
  return {byte(0xE0 | code >> 12), byte(0x80 | (code >> 6 & 0x3F)), byte(0x80 | (code & 0x3F))};
}

int compare_characters(std::string_view a, std::string_view b) {
  while (true) {
    const char32_t left = first_character(a), right = first_character(b);
    if (left != right || a.empty() || b.empty()) return static_cast<int>(left) - static_cast<int>(right);
    a.remove_prefix(length_of_first(a));
    b.remove_prefix(length_of_first(b));
  }
}

}  // namespace isl::interpreter
