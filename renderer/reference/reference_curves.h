// The curves of convolutions, in units of the support: where a point lies as seen from a curve, and the integrals of a
// window along it. Used by reference_convolution.
//
// A point's place is computed in intervals, in the curve's own axes and as seen from the nearer end, so that its
// rounding is that of the coordinates in which it shows: along an axis of space a segment may be as long as it likes.
#pragma once

#include "renderer/reference/jet.h"
#include "renderer/reference/reference_window.h"
#include "renderer/scene/database.h"

#include <algorithm>

namespace isl::ISL_REFERENCE {

struct CurveIntegrals {
  Real value, fall;       ///< ∫g ds, ∫(−g′) ds
  Vector<Real> gradient;  ///< of the first integral
};

class CurveOfSegment {
 public:
  CurveOfSegment(const scene::Component& component, Real unit);

  struct Place {
    Real from, to;        ///< where the ends are on the line, seen from the point nearest to the place
    Vector<Real> across;  ///< from that point to the place
    Size rounding;        ///< the true place is no farther away than that, or farther along where no end is in sight

    [[nodiscard]] Real beside() const { return sqrt(squared_length(across)); }
    [[nodiscard]] Real distance() const { return hypot(beside(), std::max({Real(0), from, -to})); }
  };
  [[nodiscard]] Place place(const Vector<Interval>& p) const;

  /// Precondition: the place is within the support.
  [[nodiscard]] CurveIntegrals integrals(const Place& at, const ReferenceWindow& window) const;
  /// The part of the curve within the support of places in a ball, to which nothing is nearer than √least < 1.
  [[nodiscard]] ReferenceWindow::View view(const Place& at, Real ball, Real least) const;
  /// To one side of its point nearest to a place, the curve is no shorter than that.
  [[nodiscard]] Real longer_side() const { return length_ / 2; }

 private:
  Vector<Interval> a_, b_, axis_;
  Real unit_, length_ = 0;
};

class CurveOfCircle {
 public:
  CurveOfCircle(const scene::Component& component, Real unit);

  struct Place {
    Real rho, beside, height;  ///< the distance from the axis, less the radius, and the distance from the plane
    Vector<Real> outwards;     ///< of unit length, or 0 on the axis
    Size rounding;             ///< the true place is no farther away

    [[nodiscard]] Real distance() const { return hypot(beside, height); }
  };
  [[nodiscard]] Place place(const Vector<Interval>& p) const;

  // As above.
  [[nodiscard]] CurveIntegrals integrals(const Place& at, const ReferenceWindow& window) const;
  [[nodiscard]] ReferenceWindow::View view(const Place& at, Real ball, Real least) const;
  [[nodiscard]] Real longer_side() const { return half_turn() * radius_; }

 private:
  [[nodiscard]] static Real half_turn() { return 4 * asin(sqrt(Real(0.5L))); }

  Vector<Interval> centre_, axis_;
  Real unit_, radius_;
};

}  // namespace isl::ISL_REFERENCE
