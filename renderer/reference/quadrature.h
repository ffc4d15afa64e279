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

/// The positive nodes and the weights of Gauss's rule on [−1, 1] with n = 2·kHalf nodes, from Legendre's polynomials up
/// to that degree. The nodes are the zeros of Pₙ, whose slope is the sum of (2k + 1)P_k over k = n − 1, n − 3, …;
/// Newton's method finds them from the zeros of a cosine near by. A weight is 2 over the sum of (2k + 1)P_k² over all
/// k < n (Christoffel's numbers), whose terms do not cancel.
struct GaussRule {
  std::array<Real, kHalf> nodes{}, weights{};

  GaussRule() {
    constexpr std::size_t kNodes = 2 * kHalf;
    const Real pi = 4 * asin(sqrt(Real(0.5L)));
    std::array<Real, kNodes + 1> p{1};
    for (std::size_t i = 0; i < kHalf; ++i) {
      Real x = cos(pi * (static_cast<Real>(i) + 0.75L) / (kNodes + 0.5L)), squares = 0;
      for (int newton = 0; newton < 8; ++newton) {
        p[1] = x;
        Real slope = 0;
        squares = 1;
        for (std::size_t k = 1; k < kNodes; ++k) {
          const auto odd = static_cast<Real>(2 * k + 1);
          p[k + 1] = (odd * x * p[k] - static_cast<Real>(k) * p[k - 1]) / static_cast<Real>(k + 1);
          squares += odd * p[k] * p[k];
          if (k % 2 == 1) slope += odd * p[k];
        }
        x -= p[kNodes] / slope;
      }
      nodes[i] = x;
      weights[i] = 2 / squares;
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
