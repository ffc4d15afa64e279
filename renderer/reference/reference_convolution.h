// The field of a convolved segment or circle in its component's space, with strength 1: its window
// (reference_window.h), integrated along the curve numerically. It stands beside reference_skeleton and
// reference_kernel, which do the same for functions of a distance; it must not know blobs.
//
// At one place the value and the slope are integrals with their errors, the rounding of the place and of 1 − y
// included. Over a stretch or a box only bounds of them are told, and of the bend, which holds around the integrals at
// its middle.
#pragma once

#include "renderer/reference/reference_curves.h"

#include <variant>

namespace isl::ISL_REFERENCE {

class ReferenceConvolution {
 public:
  /// Precondition: a segment or a circle, with a kernel of the mode convolution.
  ReferenceConvolution(const scene::Component& component, const scene::Kernel& kernel);

  /// The field at one place, of which the points tell the speed, too.
  [[nodiscard]] Jet at(const Vector<Jet>& p) const;

  struct Bounds {
    Jet jet;
    Real least = 0;  ///< no value is below; the lower end of `jet` may have lost its digits
  };
  /// The field of points, which are linear in t.
  [[nodiscard]] Bounds over(const Vector<Jet>& p) const;

  /// The largest effect of relative errors of the squared distances.
  [[nodiscard]] Real sensitivity(const Vector<Jet>& p) const;

 private:
  ReferenceWindow window_;
  Real unit_;  ///< one over the support
  std::variant<CurveOfSegment, CurveOfCircle> curve_;
};

}  // namespace isl::ISL_REFERENCE
