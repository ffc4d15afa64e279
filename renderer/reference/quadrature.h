// Integrates functions that are analytic but for a pair of poles, for values that the reference cannot or should not
// have in closed form.
#pragma once

#include "renderer/reference/real.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace isl::ISL_REFERENCE {

/// Half the number of Gauss's nodes in a panel.
inline constexpr std::size_t kHalf = kDigits == 113 ? 16 : 10;

/// The positive nodes and the weights of Gauss's rule on [−1, 1]. The nodes are the zeros of Legendre's polynomial of
/// degree 2·kHalf, which Newton's method finds from the zeros of a cosine near by; the weights are
/// 2/((1 − x²)P′(x)²).
struct GaussRule {
  std::array<Real, kHalf> nodes{}, weights{};

  GaussRule() {
    constexpr auto degree = static_cast<int>(2 * kHalf);
    const Real pi = 4 * asin(sqrt(Real(0.5L)));
    for (std::size_t i = 0; i < kHalf; ++i) {
      Real x = cos(pi * (static_cast<Real>(i) + 0.75L) / (degree + 0.5L)), slope = 1;
      for (int newton = 0; newton < 8; ++newton) {
        // k P_k = (2k − 1) x P_{k−1} − (k − 1) P_{k−2}, and (1 − x²) P_n′ = n (P_{n−1} − x P_n).
        Real before = 1, value = x;
        for (int k = 2; k <= degree; ++k) {
          const Real next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
          before = value;
          value = next;
        }
        slope = degree * (before - x * value) / ((1 - x) * (1 + x));
        x -= value / slope;
      }
      nodes[i] = x;
      weights[i] = 2 / ((1 - x) * (1 + x) * slope * slope);
    }
  }
};

/// Calls add(x, weight) for the nodes of the integral over [from, to] of a function with poles at ±i·pole and, of
/// others, none nearer to any x of the range. A panel is no longer than the distance of its middle from the poles: in
/// units of its half length they are beyond 2, on an ellipse about the panel whose half axes add up to 2 + √3 at least.
/// There n nodes are off by the (2 + √3)⁻²ⁿ-th part of the integrand's size (L. N. Trefethen, Approximation Theory and
/// Approximation Practice, theorem 19.3): 10⁻²² for long double, 10⁻³⁶ for 113 bits.
template <class Add>
void integrate(Real from, Real to, Real pole, const Add& add) {
  static const GaussRule rule;
  const auto panel = [&](Real a, Real b) {
    const Real middle = (a + b) / 2, half = (b - a) / 2;
    for (std::size_t i = 0; i < kHalf; ++i) {
      add(middle - half * rule.nodes[i], half * rule.weights[i]);
      add(middle + half * rule.nodes[i], half * rule.weights[i]);
    }
  };
  if (to - from <= hypot((from + to) / 2, pole)) return panel(from, to);
  // Otherwise the side away from 0 is cut off where its panel is just short enough.
  const auto from_far_end = [&](Real near, Real far, Real sign) {
    while (far > near) {
      const Real cut = far - near <= hypot((near + far) / 2, pole) ? near : std::max(near, far / 3);
      sign > 0 ? panel(cut, far) : panel(-far, -cut);
      far = cut;
    }
  };
  if (to > 0) from_far_end(std::max(from, Real(0)), to, 1);
  if (from < 0) from_far_end(std::max(-to, Real(0)), -from, -1);
}

}  // namespace isl::ISL_REFERENCE
