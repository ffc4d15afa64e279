// Functions of strings. Strings are UTF-8; lengths and positions count characters (code points), as POV-Ray does in a
// scene with `charset utf8`.
#include "interpreter/builtins/builtins.h"

#include "interpreter/builtins/characters.h"
#include "interpreter/expressions.h"
#include "interpreter/files.h"

#include <fmt/format.h>
#include <fmt/printf.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace isl::interpreter {
namespace {

namespace word = grammar::word;

Value result(const Arguments& a, std::string text) { return make_string(a.context(), std::move(text), a.span()); }

/// str's rule: `width` pads with spaces, or with zeros if it is negative; `digits` after the point, 6 if negative.
std::string formatted(double value, int width, int digits) {
  const char* const format = width < 0 ? "%0*.*f" : "%*.*f";
  return fmt::sprintf(format, std::abs(width), digits < 0 ? 6 : digits, value);
}

Value string_of_number(const Arguments& a) {
  return result(a, formatted(a.number(0), a.integer(1, -1000, 1000), a.integer(2, -1000, 1000)));
}

Value string_of_vector(const Arguments& a) {
  const int count = std::clamp(a.integer(0, -1000, 1000), 2, Value::kMaxTerms);
  if (!a[1].is_numeric()) a.fail(1, fmt::format("expected a vector, found {}", describe(a[1])));
  const std::string& separator = a.string(2);
  const int width = a.integer(3, -1000, 1000), digits = a.integer(4, -1000, 1000);
  // A number is a vector of one term here: it is not repeated.
  std::string text;
  for (int i = 0; i < count; ++i) {
    if (i > 0) text += separator;
    text += formatted(a[1].term(i), width, digits);
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

/// Positions start at 1; an empty part may start anywhere, even at position 0, as in POV-Ray.
Value substring(const Arguments& a) {
  const std::string& text = a.string(0);
  const auto first = static_cast<std::size_t>(a.integer(1, 0, 2'000'000'000));
  const auto count = static_cast<std::size_t>(a.integer(2, 0, 2'000'000'000));
  if (first == 0 || count == 0) return result(a, {});
  const std::optional<std::string_view> part = characters(text, first - 1, count);
  if (!part) {
    a.fail(0, fmt::format("expected positions in a string of {} characters, found {} to {}", character_count(text),
                          first, first + count - 1));
  }
  return result(a, std::string(*part));
}

/// Changes ASCII letters only, so that the result does not depend on a locale.
std::string with_case(std::string text, char from, char to, int shift) {
  for (char& c : text) {
    if (c >= from && c <= to) c = static_cast<char>(c + shift);
  }
  return text;
}

/// The number at the start of a string; 0 if there is none, as C's strtod (the program stays in the locale "C").
Value number_of_string(const Arguments& a) { return Value(std::strtod(a.string(0).c_str(), nullptr)); }

/// Code 0 gives an empty string.
Value character(const Arguments& a) { return result(a, character_of(static_cast<char32_t>(a.integer(0, 0, 0xFFFF)))); }

Value code_of_character(const Arguments& a) { return Value(static_cast<double>(first_character(a.string(0)))); }

/// The difference of the first characters that differ, as older strcmp implementations return it.
Value order(const Arguments& a) { return Value(static_cast<double>(compare_characters(a.string(0), a.string(1)))); }

const Builtin kStringFunctions[] = {
    {word::kw_asc, 1, 1, nullptr, code_of_character},
    {word::kw_chr, 1, 1, nullptr, character},
    {word::kw_concat, 1, Builtin::kAnyNumber, nullptr, concat},
    {word::kw_str, 3, 3, nullptr, string_of_number},
    {word::kw_file_exists, 1, 1, nullptr,
     [](const Arguments& a) { return Value(file_exists(a.context(), a.string(0)) ? 1.0 : 0.0); }},
    {word::kw_strcmp, 2, 2, nullptr, order},
    {word::kw_strlen, 1, 1, nullptr,
     [](const Arguments& a) { return Value(static_cast<double>(character_count(a.string(0)))); }},
    {word::kw_strlwr, 1, 1, nullptr,
     [](const Arguments& a) { return result(a, with_case(a.string(0), 'A', 'Z', 'a' - 'A')); }},
    {word::kw_strupr, 1, 1, nullptr,
     [](const Arguments& a) { return result(a, with_case(a.string(0), 'a', 'z', 'A' - 'a')); }},
    {word::kw_substr, 3, 3, nullptr, substring},
    {word::kw_val, 1, 1, nullptr, number_of_string},
    {word::kw_vstr, 5, 5, nullptr, string_of_vector},
};

}  // namespace

std::span<const Builtin> string_functions() { return kStringFunctions; }

}  // namespace isl::interpreter
