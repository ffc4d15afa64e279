// Functions for the closed forms of convolutions, on a number or on eight: the angle of a point of the upper
// half-plane, and three functions of an angle that vanish with a power of it. libm is not used, because its last bits
// differ between machines and pictures must not.
//
//   angle_of(x, y), y ≥ 0:  tan(θ/2) = y/(r + |x|) and tan(θ/2) = tan θ/(1 + √(1 + tan²θ)) reduce the angle of (|x|, y)
//                           to its eighth, whose tangent is at most tan(π/16) < 0.199; the series of atan up to w²³
//                           leaves 0.199²⁴/25 < 10⁻¹⁸.
//   turn_excess(θ)  = θ − sin θ cos θ                      = Σ_{k≥1} (−1)^{k+1} (2θ)^{2k+1}/(2(2k+1)!)   ~ ⅔θ³
//   sine_excess(θ)  = sin θ − θ cos θ                      = Σ_{k≥1} (−1)^{k+1} 2k θ^{2k+1}/(2k+1)!       ~ ⅓θ³
//   bell_excess(θ)  = θ(1 + 2cos²θ) − 3 sin θ cos θ        = Σ_{k≥2} (−1)^k (k − 1)(2θ)^{2k+1}/(2k+1)!    ~ (4/15)θ⁵
// For θ < 1 (½ for the first) they are computed from their series, with a remainder below 10⁻¹⁷ of the first term;
// beyond, from the formulas themselves, where cancellation costs no more than a factor of ten.
#if defined(ISL_RENDERER_FIELDS_CONVOLUTIONS_ARC_MATH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_CONVOLUTIONS_ARC_MATH_INL_H_
#undef ISL_RENDERER_FIELDS_CONVOLUTIONS_ARC_MATH_INL_H_
#else
#define ISL_RENDERER_FIELDS_CONVOLUTIONS_ARC_MATH_INL_H_
#endif

#include "renderer/simd/octet-inl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

// Overloads for numbers of functions of octet-inl.h, so that one formula serves a number and an octet.
HWY_INLINE double min(double a, double b) { return std::min(a, b); }
HWY_INLINE double max(double a, double b) { return std::max(a, b); }
HWY_INLINE double keep(bool condition, double x) { return condition ? x : 0; }
HWY_INLINE bool none(bool condition) { return !condition; }

inline constexpr double kPi = 3.14159265358979323846;

/// Σ c[k] x^k by Horner's rule.
template <class N, std::size_t Terms>
[[nodiscard]] HWY_INLINE N power_series(const std::array<double, Terms>& c, const N& x) {
  N sum(c[Terms - 1]);
  for (std::size_t k = Terms - 1; k-- > 0;) sum = sum * x + N(c[k]);
  return sum;
}

/// The angle in [0, π] of the point (x, y), y ≥ 0; 0 for (0, 0).
template <class N>
[[nodiscard]] HWY_INLINE N angle_of(const N& x, const N& y) {
  constexpr auto kSeries = [] {
    std::array<double, 12> c{};
    for (std::size_t k = 0; k < c.size(); ++k) c[k] = (k % 2 == 0 ? 8.0 : -8.0) / (2 * static_cast<double>(k) + 1);
    return c;
  }();
  const N one(1.0), least(1e-300);
  const N half = y / max(sqrt(x * x + y * y) + abs(x), least);
  const N quarter = half / (one + sqrt(one + half * half));
  const N eighth = quarter / (one + sqrt(one + quarter * quarter));
  const N angle = eighth * power_series(kSeries, eighth * eighth);
  return select(x < N(0.0), N(kPi) - angle, angle);
}

namespace arc_series {

/// Coefficients of θ^{2(k − First)} after θ^{2 First + 1}: scale(k) (−1)^{k+First} base^{2k+1}/(2k+1)!.
template <std::size_t First, std::size_t Terms, class Scale>
constexpr std::array<double, Terms> make(double base, Scale scale) {
  std::array<double, Terms> c{};
  double term = base;
  for (std::size_t k = 1; k < First + Terms; ++k) {
    const auto n = static_cast<double>(2 * k);
    term *= base * base / (n * (n + 1));
    if (k >= First) c[k - First] = ((k - First) % 2 == 0 ? term : -term) * scale(static_cast<double>(k));
  }
  return c;
}
inline constexpr auto kTurn = make<1, 10>(2, [](double) { return 0.5; });
inline constexpr auto kSine = make<1, 10>(1, [](double k) { return 2 * k; });
inline constexpr auto kBell = make<2, 13>(2, [](double k) { return k - 1; });

}  // namespace arc_series

/// θ − sin θ cos θ, from θ and sin θ cos θ.
template <class N>
[[nodiscard]] HWY_INLINE N turn_excess(const N& angle, const N& sine_cosine) {
  const N square = angle * angle;
  return select(angle < N(0.5), angle * square * power_series(arc_series::kTurn, square), angle - sine_cosine);
}

/// sin θ − θ cos θ.
template <class N>
[[nodiscard]] HWY_INLINE N sine_excess(const N& angle, const N& sine, const N& cosine) {
  const N square = angle * angle;
  return select(angle < N(1.0), angle * square * power_series(arc_series::kSine, square), sine - angle * cosine);
}

/// θ(1 + 2cos²θ) − 3 sin θ cos θ.
template <class N>
[[nodiscard]] HWY_INLINE N bell_excess(const N& angle, const N& sine, const N& cosine) {
  const N square = angle * angle;
  return select(angle < N(1.0), angle * square * square * power_series(arc_series::kBell, square),
                angle * (N(1.0) + N(2.0) * cosine * cosine) - N(3.0) * sine * cosine);
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
