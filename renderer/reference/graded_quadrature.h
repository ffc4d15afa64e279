// Integrates functions that are steep about one place, to all digits of a long double, for values that the reference
// cannot or should not have in closed form.
#pragma once

#include "renderer/reference/gauss_legendre.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace isl::reference {

/// Calls add(x, weight) for the nodes of ∫ over [from, to]. The integrand must be analytic about 0 within `scale` and,
/// farther away, within the distance of its argument. Panels grow threefold from 0, so that in units of its half length
/// a panel's nearest singularity is beyond 2, and 20 nodes of Gauss leave an error below (2 + √3)⁻⁴⁰ < 10⁻²² of it.
template <class Add>
void integrate_graded(long double from, long double to, long double scale, const Add& add) {
  static const GaussLegendre<10> gauss;
  const auto panel = [&](long double a, long double b) {
    const long double middle = (a + b) / 2, half = (b - a) / 2;
    for (std::size_t i = 0; i < gauss.nodes.size(); ++i) {
      const long double x = half * gauss.nodes[i], weight = half * gauss.weights[i];
      add(middle - x, weight);
      add(middle + x, weight);
    }
  };
  // One side of 0: sign · [near, far], near ≥ 0.
  const auto side = [&](long double sign, long double near, long double far) {
    long double begin = near, end = scale;
    while (end <= begin) end *= 3;
    for (; begin < far; end *= 3) {
      const long double cut = std::min(end, far);
      sign > 0 ? panel(begin, cut) : panel(-cut, -begin);
      begin = cut;
    }
  };
  if (to > 0) side(1, std::max(from, 0.0L), to);
  if (from < 0) side(-1, std::max(-to, 0.0L), -from);
}

}  // namespace isl::reference
