// φ(q) of one kernel (if convolved: of a plane or an infinite line), straight from its definition (q =
// squared distance over squared radius), and enclosures of φ and φ′ over ranges of q. Used by reference_field and
// reference_ray; knows nothing of skeletons or space, and leaves each shape's formulas and constants to its form
// (kernel_forms.h).
//
// For every shape, φ is convex, falls to φ = φ′ = 0 at the end of its support, q = Q, and is zero from there on. If the
// radius means the surface, φ(1) = 1 and φ′(1) = −hardness. So φ and φ′ are monotone, and their ranges over an interval
// are their values at its ends. (φ″ may jump: the metaball's does, within its support.)
#pragma once

#include "renderer/reference/interval.h"
#include "renderer/reference/kernel_forms.h"
#include "renderer/scene/database.h"

namespace isl::ISL_REFERENCE {

class ReferenceKernel {
 public:
  /// Precondition: only a quartic has the `support` meaning.
  explicit ReferenceKernel(const scene::Kernel& kernel);

  /// Q, beyond which φ = 0.
  [[nodiscard]] Interval support() const { return support_; }

  /// φ over q ≥ 0.
  [[nodiscard]] Interval value(const Interval& q) const;
  /// dφ/dq over q ≥ 0.
  [[nodiscard]] Interval slope(const Interval& q) const;

  [[nodiscard]] Real value(Real q) const { return value(Interval(q)).middle(); }
  [[nodiscard]] Real slope(Real q) const { return slope(Interval(q)).middle(); }

 private:
  KernelFormHandle form_;
  Interval support_;
};

}  // namespace isl::ISL_REFERENCE
