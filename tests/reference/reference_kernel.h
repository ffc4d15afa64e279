// φ(q) of one kernel in long double, straight from its definition (q = squared distance over squared radius), and
// enclosures of φ and φ′ over ranges of q. Used by reference_field and reference_ray; knows nothing of skeletons or
// space.
//
//   quartic, surface:  φ = (1 + (h/2)(1 − q))²                    q < Q = 1 + 2/h
//   quartic, support:  φ = (1 − q)²                               q < Q = 1           (POV-Ray's own component)
//   gaussian, surface: φ = δ(eˣ − 1 − x)/(1 − δ(1 + ln 1/δ)),     x = a(Q − q) > 0, Q = 1 + ln(1/δ)/a, δ = 10⁻³,
//                      a = h(1 − δ(1 + ln 1/δ))/(1 − δ)           (Blinn's exponential less its tangent at q = Q)
// Each is zero from Q on, convex and decreasing before; `surface` kernels have φ(1) = 1 and φ′(1) = −h.
#pragma once

#include "renderer/scene/database.h"
#include "tests/reference/interval.h"

namespace isl::reference {

class ReferenceKernel {
 public:
  /// A gaussian with the `support` meaning does not exist in the language: that is a bug of the caller.
  explicit ReferenceKernel(const scene::Kernel& kernel);

  /// Q: from here on φ = 0.
  [[nodiscard]] Interval support() const { return support_; }

  /// φ over q ≥ 0.
  [[nodiscard]] Interval value(const Interval& q) const;
  /// dφ/dq over q ≥ 0.
  [[nodiscard]] Interval slope(const Interval& q) const;

  [[nodiscard]] long double value(long double q) const { return value(Interval(q)).middle(); }
  [[nodiscard]] long double slope(long double q) const { return slope(Interval(q)).middle(); }

 private:
  /// Falls from its value at q = 0 to zero at Q; φ and φ′ are monotone functions of it.
  [[nodiscard]] Interval depth(const Interval& q) const;

  scene::KernelShape shape_;
  Interval support_;    ///< Q
  Interval rate_;       ///< quartic: −d√φ/dq. gaussian: a
  Interval amplitude_;  ///< gaussian: δ/(1 − δ(1 + ln 1/δ))
};

}  // namespace isl::reference
