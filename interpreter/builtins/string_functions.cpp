// Functions of strings. Strings are bytes in UTF-8; lengths and positions count bytes, as far as scenes in ASCII can
// tell.
#include "interpreter/builtins/builtins.h"

#include "interpreter/expressions.h"

#include <fmt/format.h>
#include <fmt/printf.h>

#include <charconv>

namespace isl::interpreter {
namespace {

namespace word = grammar::word;

Value result(const Arguments& a, std::string text) { return make_string(a.context(), std::move(text), a.span()); }

/// str's rule: `width` pads with spaces, or zeros where it is negative; `digits` after the point, 6 where negative.
std::string formatted(double value, int width, int digits) {
  const char* const format = width < 0 ? "%0*.*f" : "%*.*f";
  return fmt::sprintf(format, std::abs(width), digits < 0 ? 6 : digits, value);
}

Value string_of_number(const Arguments& a) {
  return result(a, formatted(a.number(0), a.integer(1, -1000, 1000), a.integer(2, -1000, 1000)));
}

Value string_of_vector(const Arguments& a) {
  const int count = a.integer(0, 2, 5);
  if (!a[1].is_numeric()) a.fail(1, fmt::format("expected a vector, found {}", describe(a[1])));
  const std::string& separator = a.string(2);
  const int width = a.integer(3, -1000, 1000), digits = a.integer(4, -1000, 1000);
  // A number here is a vector of one term: it does not fill the others.
  std::string text;
  for (int i = 0; i < count; ++i) {
    if (i > 0) text += separator;
    text += formatted(a[1].terms()[i], width, digits);
  }
  return result(a, std::move(text));
}

Value concat(const Arguments& a) {
  std::size_t size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) size += a.string(i).size();
  a.context().check_memory(a.span(), size);
  std::string text;
  text.reserve(size);
  for (std::size_t i = 0; i < a.size(); ++i) text += a.string(i);
  return result(a, std::move(text));
}

Value substring(const Arguments& a) {
  const std::string& text = a.string(0);
  const auto first = static_cast<std::size_t>(a.integer(1, 1, 2'000'000'000));
  const auto count = static_cast<std::size_t>(a.integer(2, 0, 2'000'000'000));
  if (first - 1 + count > text.size()) {
    a.fail(0, fmt::format("characters {} to {} of a string of {}", first, first + count - 1, text.size()));
  }
  return result(a, text.substr(first - 1, count));
}

/// The characters of ASCII only, so that the result does not depend on a locale.
std::string with_case(std::string text, char from, char to, int shift) {
  for (char& c : text) {
    if (c >= from && c <= to) c = static_cast<char>(c + shift);
  }
  return text;
}

/// The number at the start of a string; 0 where there is none, as C's atof.
Value number_of_string(const Arguments& a) {
  std::string_view text = a.string(0);
  text.remove_prefix(std::min(text.find_first_not_of(" \t\n\r"), text.size()));
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return Value(value);
}

Value character(const Arguments& a) {
  const int code = a.integer(0, 1, 0xFFFF);
  std::string text;
  if (code < 0x80) {
    text = {static_cast<char>(code)};
  } else if (code < 0x800) {
    text = {static_cast<char>(0xC0 | code >> 6), static_cast<char>(0x80 | (code & 0x3F))};
  } else {
    text = {static_cast<char>(0xE0 | code >> 12), static_cast<char>(0x80 | (code >> 6 & 0x3F)),
            static_cast<char>(0x80 | (code & 0x3F))};
  }
  return result(a, std::move(text));
}

Value code_of_character(const Arguments& a) {
  const std::string& text = a.string(0);
  if (text.empty()) a.fail(0, "the string is empty");
  return Value(static_cast<unsigned char>(text[0]));
}

Value order(const Arguments& a) {
  const int sign = a.string(0).compare(a.string(1));
  return Value(sign < 0 ? -1.0 : sign > 0 ? 1.0 : 0.0);
}

const Builtin kFunctions[] = {
    {word::kw_asc, 1, 1, nullptr, code_of_character},
    {word::kw_chr, 1, 1, nullptr, character},
    {word::kw_concat, 1, Builtin::kAnyNumber, nullptr, concat},
    {word::kw_str, 3, 3, nullptr, string_of_number},
    {word::kw_strcmp, 2, 2, nullptr, order},
    {word::kw_strlen, 1, 1, nullptr, [](const Arguments& a) { return Value(static_cast<double>(a.string(0).size())); }},
    {word::kw_strlwr, 1, 1, nullptr,
     [](const Arguments& a) { return result(a, with_case(a.string(0), 'A', 'Z', 'a' - 'A')); }},
    {word::kw_strupr, 1, 1, nullptr,
     [](const Arguments& a) { return result(a, with_case(a.string(0), 'a', 'z', 'A' - 'a')); }},
    {word::kw_substr, 3, 3, nullptr, substring},
    {word::kw_val, 1, 1, nullptr, number_of_string},
    {word::kw_vstr, 5, 5, nullptr, string_of_vector},
};

}  // namespace

std::span<const Builtin> string_functions() { return kFunctions; }

}  // namespace isl::interpreter
