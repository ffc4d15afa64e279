// The field of a convolved segment or circle in its component's space, with strength 1: its window
// (reference_window.h), integrated along the curve numerically. It stands beside reference_skeleton and
// reference_kernel, which do the same for functions of a distance; it must not know blobs.
//
// At one place the value and the slope are integrals with their errors, the rounding of the place and of 1 − y
// included. Over a stretch or a box only bounds of them are told, and of the bend, which holds around the integrals at
// its middle.
#pragma once

#include "renderer/reference/jet.h"
#include "renderer/reference/reference_window.h"
#include "renderer/scene/database.h"

#include <functional>

namespace isl::ISL_REFERENCE {

/// A curve in units of the support.
struct Curve {
  Real far;  ///< no point of it is farther from the origin
  std::function<Real(const Vector<Real>& p)> distance;
  struct Integrals {
    Real value, fall;       ///< ∫g ds, ∫(−g′) ds
    Vector<Real> gradient;  ///< of the first integral
  };
  /// The integrals at a point within the support.
  std::function<Integrals(const Vector<Real>& p, const ReferenceWindow& window)> integrals;
  /// The view from a ball about p, from which nothing is nearer than √least, least < 1.
  std::function<ReferenceWindow::View(const Vector<Real>& p, Real ball, Real least)> view;
};

/// The segment from a to b, and the circle about a and the axis b, scaled by `unit`.
[[nodiscard]] Curve segment_curve(const scene::Component& component, Real unit);
[[nodiscard]] Curve circle_curve(const scene::Component& component, Real unit);

class ReferenceConvolution {
 public:
  /// Precondition: a segment or a circle, with a kernel of the mode convolution.
  ReferenceConvolution(const scene::Component& component, const scene::Kernel& kernel);

  /// The field of points, which are linear in t.
  [[nodiscard]] Jet of(const Vector<Jet>& p, bool is_one_place) const;
  /// The largest effect of relative errors of the squared distances.
  [[nodiscard]] Real sensitivity(const Vector<Jet>& p) const;

 private:
  ReferenceWindow window_;
  Real unit_;  ///< one over the support
  Curve curve_;
};

}  // namespace isl::ISL_REFERENCE
