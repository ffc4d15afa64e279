// The error of the interpolation. f(v) = 1.055 v^(5/12) − 0.055, interpolated on a piece [a, a + h] with its value and
// slope at both ends, is off by at most h⁴/384 · max|f⁗| (Hermite's remainder). |f⁗(v)| = 1.055 · 5/12 · 7/12 · 19/12 ·
// 31/12 · v^(5/12 − 4) < 1.05 v^(5/12 − 4), which is greatest at a, and h ≤ a/32; so the error is below 1.05/(384 ·
// 32⁴) · a^(5/12) < 2.61e-9. Rounding in the curve and in the cubic adds less than 1e-13.
#include "renderer/image/display_codes.h"

#include "base/check.h"
#include "renderer/image/transfer.h"

#include <cmath>

namespace isl::render {
namespace {

constexpr double kInterpolationError = 2.7e-9;

/// The slope of the power law at `linear`, where the curve has the value `code`.
double slope(double linear, double code) { return (code + 0.055) / (2.4 * linear); }

}  // namespace

DisplayCodes::DisplayCodes(int most) : most_(most), margin_(kInterpolationError * most) {
  ISL_CHECK(most >= 1 && most <= 65535, "{} codes", most);
  double begin = kFirst, value = srgb_from_linear(begin);
  for (Cubic& piece : pieces_) {
    const double end = std::bit_cast<double>((piece_bits(begin) + 1) << (52 - kPieceBits));
    const double h = end - begin, end_value = srgb_from_linear(end);
    const double left = slope(begin, value), right = slope(end, end_value), chord = (end_value - value) / h;
    piece = {begin, {value, left, (3 * chord - 2 * left - right) / h, (left + right - 2 * chord) / (h * h)}};
    begin = end;
    value = end_value;
  }
}

std::uint32_t DisplayCodes::exact(double linear) const {
  return static_cast<std::uint32_t>(std::floor(display_from_linear(linear) * most_ + 0.5));
}

}  // namespace isl::render
