#include "cli/options/option_values.h"

#include "grammar/suggest.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

namespace isl::cli {
namespace {

/// The whole text as a number; no sign `+`, no blanks, no "inf" or "nan".
template <class Number>
std::optional<Number> number_of(std::string_view text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  if constexpr (std::is_floating_point_v<Number>) {
    if (!std::isfinite(value)) return std::nullopt;
  }
  return value;
}

std::size_t physical_memory() {
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long page_bytes = sysconf(_SC_PAGESIZE);
  if (pages <= 0 || page_bytes <= 0) return std::size_t{4} << 30;  // unknown: a small machine's memory
  return static_cast<std::size_t>(pages) * static_cast<std::size_t>(page_bytes);
}

/// Returns nothing if the size is zero, negative, or more than any machine has.
std::optional<std::size_t> whole_bytes(double bytes) {
  if (!(bytes > 0 && bytes < 0x1p62)) return std::nullopt;
  return static_cast<std::size_t>(bytes);
}

/// `4G`, `512M`, `100K`, or a plain number.
std::optional<std::size_t> bytes_of(std::string_view text) {
  double factor = 1;
  if (text.ends_with('K')) factor = 0x1p10;
  if (text.ends_with('M')) factor = 0x1p20;
  if (text.ends_with('G')) factor = 0x1p30;
  const auto value = number_of<double>(factor == 1 ? text : text.substr(0, text.size() - 1));
  return value ? whole_bytes(*value * factor) : std::nullopt;
}

bool is_identifier(std::string_view text) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  if (text.empty() || !is_letter(text.front())) return false;
  for (const char c : text) {
    if (!is_letter(c) && !(c >= '0' && c <= '9')) return false;
  }
  return true;
}

}  // namespace

Parsed<std::int64_t> parse_integer(std::string_view text, std::int64_t low, std::int64_t high) {
  const auto value = number_of<std::int64_t>(text);
  if (!value) return Parsed<std::int64_t>::error(fmt::format("expected a whole number, found `{}`", text));
  if (*value < low || *value > high) {
    return Parsed<std::int64_t>::error(
        fmt::format("expected a whole number from {} to {}, found {}", low, high, *value));
  }
  return *value;
}

Parsed<double> parse_number(std::string_view text, double low, double high) {
  const auto value = number_of<double>(text);
  if (!value) return Parsed<double>::error(fmt::format("expected a number, found `{}`", text));
  if (*value < low || *value > high) {
    const bool bounded = high < std::numeric_limits<double>::max();
    return Parsed<double>::error(bounded ? fmt::format("expected a number from {} to {}, found {}", low, high, text)
                                         : fmt::format("expected a number of at least {}, found {}", low, text));
  }
  return *value;
}

Parsed<PictureSize> parse_size(std::string_view text) {
  const std::size_t cross = text.find_first_of("xX");
  if (cross != std::string_view::npos) {
    const auto width = number_of<int>(text.substr(0, cross));
    const auto height = number_of<int>(text.substr(cross + 1));
    const auto fits = [](int side) { return side >= 1 && side <= kMaxPictureSide; };
    if (width && height && fits(*width) && fits(*height)) return PictureSize{*width, *height};
  }
  return Parsed<PictureSize>::error(
      fmt::format("expected WIDTHxHEIGHT in pixels from 1 to {}, such as 800x600, found `{}`", kMaxPictureSide, text));
}

Parsed<std::array<int, 4>> parse_crop(std::string_view text) {
  std::array<int, 4> sides{};
  std::string_view rest = text;
  bool good = true;
  for (std::size_t i = 0; i < sides.size() && good; ++i) {
    const std::size_t comma = i + 1 < sides.size() ? rest.find(',') : rest.size();
    const auto side = comma == std::string_view::npos ? std::nullopt : number_of<int>(rest.substr(0, comma));
    good = side && *side >= 0 && *side <= kMaxPictureSide;
    if (!good) break;
    sides[i] = *side;
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  if (!good || sides[0] >= sides[2] || sides[1] >= sides[3]) {
    return Parsed<std::array<int, 4>>::error(
        fmt::format("expected X0,Y0,X1,Y1 in pixels with X0 < X1 and Y0 < Y1, found `{}`", text));
  }
  return sides;
}

Parsed<render::Tolerance> parse_tolerance(std::string_view text) {
  const bool in_pixels = text.ends_with("px");
  const auto value = number_of<double>(in_pixels ? text.substr(0, text.size() - 2) : text);
  if (value && *value > 0) return render::Tolerance{*value, in_pixels};
  return Parsed<render::Tolerance>::error(
      fmt::format("expected a length above zero in pixels (0.05px) or scene units (1e-4), found `{}`", text));
}

Parsed<Define> parse_define(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) {
    return Parsed<Define>::error(fmt::format("expected NAME=VALUE, found `{}`", text));
  }
  const std::string_view name = text.substr(0, equals);
  std::string_view value = text.substr(equals + 1);
  if (!is_identifier(name)) {
    return Parsed<Define>::error(fmt::format(
        "expected a variable's name of letters, digits and _, not beginning with a digit, found `{}`", name));
  }
  if (const auto number = number_of<double>(value)) return Define{std::string(name), *number};
  if (value.size() >= 2 && value.front() == '"' && value.back() == '"') value = value.substr(1, value.size() - 2);
  return Define{std::string(name), std::string(value)};
}

Parsed<std::size_t> parse_bytes(std::string_view text) {
  const auto value = bytes_of(text);
  if (value) return *value;
  return Parsed<std::size_t>::error(fmt::format("expected bytes (4G, 512M, 64K), found `{}`", text));
}

Parsed<std::size_t> parse_memory(std::string_view text) {
  std::optional<std::size_t> value = bytes_of(text);
  if (text.ends_with('%')) {
    const auto percent = number_of<double>(text.substr(0, text.size() - 1));
    if (percent) value = whole_bytes(*percent * static_cast<double>(physical_memory()) / 100);
  }
  if (value) return *value;
  return Parsed<std::size_t>::error(
      fmt::format("expected a percentage of the memory (75%) or bytes (4G, 512M), found `{}`", text));
}

std::string to_text(const render::Tolerance& tolerance) {
  return fmt::format("{}{}", tolerance.value, tolerance.in_pixels ? "px" : "");
}

Parsed<std::vector<std::string_view>> parse_names(std::string_view text, std::string_view kind,
                                                  const std::vector<std::string_view>& known) {
  std::vector<std::string_view> names;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view name = text.substr(begin, end - begin);
    const auto found = std::ranges::find(known, name);
    if (found == known.end()) {
      const auto similar = grammar::closest(name, known);
      return Parsed<std::vector<std::string_view>>::error(fmt::format(
          "unknown {} `{}`; {}", kind, name,
          similar ? fmt::format("did you mean `{}`?", *similar) : fmt::format("there are {}", fmt::join(known, ", "))));
    }
    names.push_back(*found);
    begin = end + 1;
  }
  return names;
}

}  // namespace isl::cli
