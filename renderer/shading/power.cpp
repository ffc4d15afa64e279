// x^y = 2^(y log₂ x).
//
// log₂: x = 2^e m with m in [√½, √2); ln m = 2 artanh(s), s = (m − 1)/(m + 1), |s| < 0.172, by its Taylor series
// s + s³/3 + …: after s²³/23 the rest is below s²⁵/25 < 4e-21.
// 2^z = 2^n e^(f ln 2), n the nearest integer, |f ln 2| < 0.347, by Taylor: after the 14th power the rest is below
// 2e-19. Whole exponents up to kMaxWhole are repeated squarings instead: brilliance 1, 2 and phong_size 40 are the
// common case, and they are then nearly exact.
#include "renderer/shading/power.h"

#include <array>
#include <cmath>
#include <limits>

namespace isl::render {
namespace {

constexpr double kLn2 = 0.69314718055994530942;
constexpr double kSqrtHalf = 0.70710678118654752440;
constexpr double kMaxWhole = 64;

double whole_power(double x, int n) noexcept {
  double result = 1;
  for (double square = x; n > 0; n >>= 1, square *= square) {
    if ((n & 1) != 0) result *= square;
  }
  return result;
}

double log2_of(double x) noexcept {
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent);  // [½, 1); exact, as is ldexp below
  if (mantissa < kSqrtHalf) mantissa *= 2, --exponent;
  const double s = (mantissa - 1) / (mantissa + 1);
  const double square = s * s;
  double series = 0;
  for (int n = 23; n >= 1; n -= 2) series = series * square + 1.0 / n;
  return exponent + 2 * s * series / kLn2;
}

double exp2_of(double z) noexcept {
  if (z < -1100) return 0;
  if (z > 1100) return std::numeric_limits<double>::infinity();
  const double n = std::floor(z + 0.5);
  const double f = (z - n) * kLn2;
  double series = 1;
  for (int k = 14; k >= 1; --k) series = 1 + series * f / k;
  return std::ldexp(series, static_cast<int>(n));
}

}  // namespace

double power(double x, double y) noexcept {
  if (y == 0) return 1;
  if (!(x >= 0)) return std::numeric_limits<double>::quiet_NaN();
  if (y > 0 && y <= kMaxWhole && y == std::floor(y)) return whole_power(x, static_cast<int>(y));
  if (x == 0) return y > 0 ? 0 : std::numeric_limits<double>::infinity();
  if (x == 1) return 1;
  if (std::isinf(x)) return y > 0 ? x : 0;
  return exp2_of(y * log2_of(x));
}

}  // namespace isl::render
