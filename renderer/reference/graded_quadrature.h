// Integrates functions that are steep about one place, to all digits of the type, for values that the reference cannot
// or should not have in closed form.
#pragma once

#include "renderer/reference/gauss_legendre.h"

#include <algorithm>
#include <cstddef>

namespace isl::ISL_REFERENCE {

/// Calls add(x, weight) for the nodes of ∫ over [from, to]. The integrand must be analytic about 0 within `scale` and,
/// farther away, within the distance of its argument. Panels grow threefold from 0, so that in units of its half length
/// a panel's nearest singularity is beyond 2, and n nodes of Gauss leave an error below (2 + √3)⁻²ⁿ of it: 10⁻²² with
/// the 20 nodes of a long double, and 10⁻³⁶ with the 32 of 113 bits.
template <class Add>
void integrate_graded(Real from, Real to, Real scale, const Add& add) {
  static const GaussLegendre<kDigits == 113 ? 16 : 10> gauss;
  const auto panel = [&](Real a, Real b) {
    const Real middle = (a + b) / 2, half = (b - a) / 2;
    for (std::size_t i = 0; i < gauss.nodes.size(); ++i) {
      const Real x = half * gauss.nodes[i], weight = half * gauss.weights[i];
      add(middle - x, weight);
      add(middle + x, weight);
    }
  };
  // One side of 0: sign · [near, far], near ≥ 0.
  const auto side = [&](Real sign, Real near, Real far) {
    Real begin = near, end = scale;
    while (end <= begin) end *= 3;
    for (; begin < far; end *= 3) {
      const Real cut = std::min(end, far);
      sign > 0 ? panel(begin, cut) : panel(-cut, -begin);
      begin = cut;
    }
  };
  if (to > 0) side(1, std::max(from, Real(0)), to);
  if (from < 0) side(-1, std::max(-to, Real(0)), -from);
}

}  // namespace isl::ISL_REFERENCE
