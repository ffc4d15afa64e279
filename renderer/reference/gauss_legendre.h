// The nodes of Gauss's quadrature on [−1, 1].
#pragma once

#include "renderer/reference/real.h"

#include <array>
#include <cstddef>

namespace isl::ISL_REFERENCE {

/// The positive nodes of the rule with 2n nodes, and their weights; it is exact for polynomials of degree 4n − 1.
template <std::size_t n>
struct GaussLegendre {
  std::array<Real, n> nodes{}, weights{};

  /// The nodes are the roots of the Legendre polynomial P of degree m = 2n. Newton's method starts from Tricomi's
  /// estimates, so near that every root is found, and squares its error in each step; the weights are
  /// 2 / ((1 − x²) P′(x)²). Abramowitz and Stegun, 22.16.6 and 25.4.29.
  GaussLegendre() {
    constexpr std::size_t m = 2 * n;
    for (std::size_t i = 0; i < n; ++i) {
      Real x = cos(kPi * (4 * i + 3) / (4 * m + 2)), slope = 0;
      for (int step = 0; step < 8; ++step) {
        Real before = 1, value = x;
        for (std::size_t k = 2; k <= m; ++k) {
          const Real next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
          before = value;
          value = next;
        }
        slope = m * (before - x * value) / (1 - x * x);
        x -= value / slope;
      }
      nodes[i] = x;
      weights[i] = 2 / ((1 - x * x) * slope * slope);
    }
  }
};

}  // namespace isl::ISL_REFERENCE
