// Roots of a cubic in Bernstein form on [0, 1], b₀ … b₃. Of the usual bases, Bernstein's is the best conditioned there
// (Farouki and Rajan 1987).
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

namespace isl::render {

struct CubicPoint {
  double value, slope;
};

/// Value and slope by de Casteljau's scheme.
[[nodiscard]] inline CubicPoint cubic_at(double b0, double b1, double b2, double b3, double u) noexcept {
  const double v = 1 - u;
  const double c0 = v * b0 + u * b1, c1 = v * b1 + u * b2, c2 = v * b2 + u * b3;
  const double d0 = v * c0 + u * c1, d1 = v * c1 + u * c2;
  return {v * d0 + u * d1, 3 * (d1 - d0)};
}

/// The root of a cubic with b₀ ≤ 0 ≤ b₃ (one of them, if there are three), to a few parts in 10⁷: a first guess for
/// Newton's method on the true function, which doubles its digits. Newton in a bracket, from the regula falsi point.
[[nodiscard]] inline double root_of_rising_cubic(double b0, double b1, double b2, double b3) noexcept {
  double low = 0, high = 1;
  double u = b0 / (b0 - b3);
  for (int i = 0; i < 8; ++i) {
    if (!(u > low && u < high)) u = 0.5 * (low + high);
    const CubicPoint p = cubic_at(b0, b1, b2, b3, u);
    (p.value > 0 ? high : low) = u;
    const double step = p.value / p.slope;
    u -= step;
    if (std::abs(step) < 0x1p-24) break;
  }
  return std::clamp(u, low, high);
}

/// The first u in (0, 1] at which a cubic that starts below zero (b₀ < 0) reaches it; 2 if it does not. Between its
/// stationary points, the roots of the quadratic bⱼ₊₁ − bⱼ, it is monotone; there the sign change is bracketed and
/// bisected by Newton steps.
[[nodiscard]] inline double first_crossing_of_cubic(double b0, double b1, double b2, double b3) noexcept {
  const double c0 = b1 - b0, c1 = b2 - b1, c2 = b3 - b2;  // p′/3 in Bernstein form: α u² + 2β u + c₀
  const double alpha = c0 - 2 * c1 + c2, beta = c1 - c0;
  double stops[3] = {1, 1, 1};
  int n = 0;
  const double discriminant = beta * beta - alpha * c0;
  if (discriminant > 0) {
    const double q = -(beta + std::copysign(std::sqrt(discriminant), beta));
    for (const double u : {q / alpha, c0 / q}) {
      if (u > 0 && u < 1) stops[n++] = u;
    }
    if (n == 2 && stops[0] > stops[1]) std::swap(stops[0], stops[1]);
  }
  double from = 0;
  for (int i = 0; i <= n; ++i) {
    const double to = i < n ? stops[i] : 1;
    if (cubic_at(b0, b1, b2, b3, to).value >= 0) {
      double low = from, high = to, u = 0.5 * (low + high);
      for (int k = 0; k < 64 && high - low > 0x1p-52; ++k) {
        const CubicPoint p = cubic_at(b0, b1, b2, b3, u);
        (p.value >= 0 ? high : low) = u;
        u -= p.value / p.slope;
        if (!(u > low && u < high)) u = 0.5 * (low + high);
      }
      return high;
    }
    from = to;
  }
  return 2;
}

}  // namespace isl::render
