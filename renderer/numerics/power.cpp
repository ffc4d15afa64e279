// x^y = 2^(y log₂ x), both functions by a table and a short series about its nearest entry (Tang 1990, Table-driven
// implementation of the logarithm function).
//
// log₂: x = 2^e z with z in [√½, √2) is near 1/c for one of 128 numbers c of at most 10 digits, so that r = c z − 1 is
// exact but for the rounding of its last part, and |r| < 2⁻⁷: log₂ x = e − log₂ c + log₂(1 + r). About 1, c is 1, so
// that no digit is lost there. After r⁸/8 the rest is below 2⁻⁶⁶.
// 2^t: t = n + j/64 + f with |f| ≤ 1/128, so 2^t = 2ⁿ · 2^(j/64) · e^(f ln 2), |f ln 2| < 0.0055, by Taylor: after the
// sixth power the rest is below 2⁻⁶⁵.
//
// Whole exponents up to kMaxWhole are repeated squarings instead: brilliance 1, 2 and phong_size 40 are the common
// case, and they are then nearly exact.
#include "renderer/numerics/power.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace isl::render {
namespace {

constexpr double kMaxWhole = 64;
/// Adding and subtracting this rounds numbers below 2⁵¹ to integers.
constexpr double kToInteger = 0x1.8p52;

double whole_power(double x, int n) noexcept {
  double result = 1;
  for (double square = x; n > 0; n >>= 1, square *= square) {
    if ((n & 1) != 0) result *= square;
  }
  return result;
}

constexpr long double kLn2 = 0.693147180559945309417232121458176568L;

/// ln x for x in [½, 2], by artanh's series.
constexpr long double slow_log(long double x) {
  const long double s = (x - 1) / (x + 1);
  long double sum = 0, power = s;
  for (int i = 0; i < 40; ++i, power *= s * s) sum += power / static_cast<long double>(2 * i + 1);
  return 2 * sum;
}

constexpr long double slow_exp(long double x) {
  long double sum = 0, term = 1;
  for (int i = 1; i < 30; ++i) {
    sum += term;
    term *= x / static_cast<long double>(i);
  }
  return sum;
}

constexpr int kLogBits = 7;
/// Of √½: numbers from here on up to √2 have the same exponent above it.
constexpr std::uint64_t kLeast = 0x3FE6A09E667F3BCD;

struct Logarithm {
  double c, log2_of_inverse;  ///< c and −log₂ c
};
constexpr auto kLogarithms = [] {
  std::array<Logarithm, 1 << kLogBits> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    constexpr std::uint64_t kStep = std::uint64_t{1} << (52 - kLogBits);
    const auto low = std::bit_cast<double>(kLeast + i * kStep), high = std::bit_cast<double>(kLeast + (i + 1) * kStep);
    const double exact = 2 / (low + high);
    constexpr double kUnits = 0x1.8p52;  // rounds to a whole number what is added to it
    const double c = low <= 1 && 1 < high ? 1 : (exact * 512 + kUnits - kUnits) / 512;
    table[i] = {c, static_cast<double>(-slow_log(c) / kLn2)};
  }
  return table;
}();

constexpr int kExpBits = 6;
/// 2^(j/64).
constexpr auto kPowers = [] {
  std::array<double, 1 << kExpBits> table{};
  for (std::size_t j = 0; j < table.size(); ++j) {
    table[j] = static_cast<double>(slow_exp(kLn2 * static_cast<long double>(j) / (1 << kExpBits)));
  }
  return table;
}();

/// log₂ x for x > 0; a denormal x is scaled into the normal range first.
[[gnu::always_inline]] inline double log2_of(double x) noexcept {
  constexpr double kLeastNormal = 0x1p-1022;
  double exponent = 0;
  if (x < kLeastNormal) {
    x *= 0x1p54;
    exponent = -54;
  }
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t above = bits - kLeast;
  const Logarithm& near = kLogarithms[(above >> (52 - kLogBits)) & ((1 << kLogBits) - 1)];
  const auto whole = static_cast<std::int64_t>(above) >> 52;
  exponent += static_cast<double>(whole);
  const std::uint64_t mantissa = bits - (static_cast<std::uint64_t>(whole) << 52);
  constexpr std::uint64_t kUpper = ~((std::uint64_t{1} << 27) - 1);
  const auto z = std::bit_cast<double>(mantissa), upper = std::bit_cast<double>(mantissa & kUpper);
  const double r = (upper * near.c - 1) + (z - upper) * near.c;
  const double square = r * r;
  const double series =
      square * ((-0.5 + r * (1.0 / 3)) +
                square * ((-0.25 + r * (1.0 / 5)) + square * ((-1.0 / 6 + r * (1.0 / 7)) - square / 8)));
  constexpr auto kPerLn2 = static_cast<double>(1 / kLn2);
  return (exponent + near.log2_of_inverse) + kPerLn2 * (r + series);
}

[[gnu::always_inline]] inline double exp2_of(double t) noexcept {
  if (!(t >= -1100)) return std::isnan(t) ? t : 0;
  if (t > 1100) return std::numeric_limits<double>::infinity();
  constexpr double kSteps = 1 << kExpBits;
  const double nearest = t * kSteps + kToInteger;
  const double x = (t - (nearest - kToInteger) / kSteps) * static_cast<double>(kLn2);
  const auto place = static_cast<std::int32_t>(std::bit_cast<std::uint64_t>(nearest));
  const double table = kPowers[static_cast<std::size_t>(place & ((1 << kExpBits) - 1))];
  const double square = x * x;
  const double series =
      x + square * ((1.0 / 2 + x * (1.0 / 6)) + square * ((1.0 / 24 + x * (1.0 / 120)) + square * (1.0 / 720)));
  // The power of two is applied in two halves, so that neither factor leaves the range of normal numbers.
  const int n = place >> kExpBits, half = n / 2;
  const auto power_of_two = [](int e) { return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + e) << 52); };
  return (table + table * series) * power_of_two(half) * power_of_two(n - half);
}

/// x^y where it takes no logarithm.
std::optional<double> simple_power(double x, double y) noexcept {
  if (y == 0) return 1;
  if (!(x >= 0)) return std::numeric_limits<double>::quiet_NaN();
  if (y > 0 && y <= kMaxWhole && y == (y + kToInteger) - kToInteger) return whole_power(x, static_cast<int>(y));
  if (x == 0) return y > 0 ? 0 : std::numeric_limits<double>::infinity();
  if (x == 1) return 1;
  if (std::isinf(x)) return y > 0 ? x : 0;
  return std::nullopt;
}

}  // namespace

double power(double x, double y) noexcept {
  const std::optional<double> simple = simple_power(x, y);
  return simple ? *simple : exp2_of(y * log2_of(x));
}

void powers(std::span<const double> x, std::span<const double> y, std::span<double> result) noexcept {
  constexpr std::size_t kMost = 64;
  std::array<std::uint8_t, kMost> places;
  for (std::size_t first = 0; first < x.size(); first += kMost) {
    const std::size_t end = std::min(x.size() - first, kMost);
    std::size_t count = 0;
    for (std::size_t i = 0; i < end; ++i) {
      const std::optional<double> simple = simple_power(x[first + i], y[first + i]);
      if (simple) result[first + i] = *simple;
      places[count] = static_cast<std::uint8_t>(i);
      count += simple ? 0 : 1;
    }
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = first + places[k];
      result[i] = y[i] * log2_of(x[i]);
    }
    for (std::size_t k = 0; k < count; ++k) {
      double& value = result[first + places[k]];
      value = exp2_of(value);
    }
  }
}

double exponential(double x) noexcept {
  constexpr auto kLog2OfE = static_cast<double>(1 / kLn2);
  return exp2_of(x * kLog2OfE);
}

}  // namespace isl::render
