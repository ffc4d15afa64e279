// The values of options as the user writes them: `640x480`, `0.05px`, `75%`. Text in, value or error out; knows nothing
// of the option, so that the same readers serve the command line and `global_settings`.
#pragma once

#include "renderer/rays/tracer_options.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace isl::cli {

/// The limit of a number that has none.
inline constexpr double kUnbounded = std::numeric_limits<double>::max();

/// A value, or the reason why the text is invalid: lower case, no full stop, says what was found.
template <class T>
class Parsed {
 public:
  Parsed(T value) : state_(std::in_place_index<0>, std::move(value)) {}  // NOLINT: a value is a result
  static Parsed error(std::string message) { return Parsed(std::in_place_index<1>, std::move(message)); }

  [[nodiscard]] bool ok() const { return state_.index() == 0; }
  [[nodiscard]] const T& value() const { return std::get<0>(state_); }
  [[nodiscard]] const std::string& message() const { return std::get<1>(state_); }

 private:
  Parsed(std::in_place_index_t<1> at, std::string message) : state_(at, std::move(message)) {}
  std::variant<T, std::string> state_;
};

/// Larger pictures are typing errors; the film alone would need some hundred gigabytes.
inline constexpr int kMaxPictureSide = 65536;

/// Pixels across and down.
struct PictureSize {
  int width = 800;
  int height = 600;
  friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

/// A variable set before the scene's first line.
using Define = std::pair<std::string, std::variant<double, std::string>>;

/// A whole number from `low` to `high`.
[[nodiscard]] Parsed<std::int64_t> parse_integer(std::string_view text, std::int64_t low, std::int64_t high);

/// A finite number of at least `low` and at most `high`.
[[nodiscard]] Parsed<double> parse_number(std::string_view text, double low, double high);

/// `WxH`, each from 1 to 65536.
[[nodiscard]] Parsed<PictureSize> parse_size(std::string_view text);

/// `X0,Y0,X1,Y1` in pixels from the top left corner: columns X0 … X1 − 1, rows Y0 … Y1 − 1.
[[nodiscard]] Parsed<std::array<int, 4>> parse_crop(std::string_view text);

/// `0.05px` (pixels) or `1e-4` (scene units); positive and finite.
[[nodiscard]] Parsed<render::Tolerance> parse_tolerance(std::string_view text);

/// `NAME=VALUE`: a number where VALUE reads as one, else a string; quotes around a string are taken off.
[[nodiscard]] Parsed<Define> parse_define(std::string_view text);

/// Bytes: `4G`, `512M`, `100K`, or a plain number.
[[nodiscard]] Parsed<std::size_t> parse_bytes(std::string_view text);
/// Bytes: `75%` of this machine's memory, or `4G`, `512M`, `100K`, or a plain number.
[[nodiscard]] Parsed<std::size_t> parse_memory(std::string_view text);

/// The reverse: the shortest text that reads as the same value.
[[nodiscard]] std::string to_text(const render::Tolerance& tolerance);

/// Names behind commas, each of them known; `kind` says in the message what they name.
[[nodiscard]] Parsed<std::vector<std::string_view>> parse_names(std::string_view text, std::string_view kind,
                                                                const std::vector<std::string_view>& known);

}  // namespace isl::cli
