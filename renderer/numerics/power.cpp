// x^y = 2^(y log₂ x).
//
// log₂: x = 2^e m with m in [√½, √2); ln m = 2 artanh(s), s = (m − 1)/(m + 1), |s| < 0.172, by its Taylor series
// s + s³/3 + …: after s²³/23 the rest is below s²⁵/25 < 4e-21.
// 2^z = 2^n e^(f ln 2), n the nearest integer, |f ln 2| < 0.347, by Taylor: after the 15th power the rest is below
// 3e-21. Whole exponents up to kMaxWhole are repeated squarings instead: brilliance 1, 2 and phong_size 40 are the
// common case, and they are then nearly exact.
#include "renderer/numerics/power.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
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

/// Σ cᵢ xⁱ, as two interleaved sums in x²: half as long a chain of dependent operations as Horner's.
template <std::size_t n>
double polynomial(const std::array<double, n>& c, double x) noexcept {
  static_assert(n % 2 == 0);
  const double square = x * x;
  double even = c[n - 2], odd = c[n - 1];
  for (std::size_t i = n - 2; i >= 2; i -= 2) {
    even = even * square + c[i - 2];
    odd = odd * square + c[i - 1];
  }
  return even + x * odd;
}

/// log₂ x for x > 0; a denormal x is scaled into the normal range first.
double log2_of(double x) noexcept {
  // 2/((2i + 1) ln 2): artanh's series, doubled and in units of ln 2.
  static constexpr auto kSeries = [] {
    std::array<double, 12> c{};
    for (std::size_t i = 0; i < c.size(); ++i) c[i] = 2 / (kLn2 * static_cast<double>(2 * i + 1));
    return c;
  }();
  constexpr double kLeastNormal = 0x1p-1022;
  double exponent = 0;
  if (x < kLeastNormal) {
    x *= 0x1p54;
    exponent = -54;
  }
  const auto bits = std::bit_cast<std::uint64_t>(x);
  exponent += static_cast<double>(static_cast<int>(bits >> 52) - 1022);
  double mantissa = std::bit_cast<double>((bits & 0xFFFFFFFFFFFFFull) | 0x3FE0000000000000ull);  // [½, 1)
  if (mantissa < kSqrtHalf) {
    mantissa *= 2;
    exponent -= 1;
  }
  const double s = (mantissa - 1) / (mantissa + 1);
  return exponent + s * polynomial(kSeries, s * s);
}

double exp2_of(double z) noexcept {
  static constexpr auto kSeries = [] {
    std::array<double, 16> c{};
    double factorial = 1;
    for (std::size_t i = 0; i < c.size(); ++i) {
      c[i] = 1 / factorial;
      factorial *= static_cast<double>(i + 1);
    }
    return c;
  }();
  if (z < -1100) return 0;
  if (z > 1100) return std::numeric_limits<double>::infinity();
  const double n = std::floor(z + 0.5);
  const double series = polynomial(kSeries, (z - n) * kLn2);
  // The power of two is applied in two halves, so that neither factor leaves the range of normal numbers.
  const int half = static_cast<int>(n) / 2, rest = static_cast<int>(n) - half;
  const auto power_of_two = [](int e) { return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + e) << 52); };
  return series * power_of_two(half) * power_of_two(rest);
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
