// Segment: with w from its nearer end to the place and the unit axis a, the place is w·a along and a × (w × a) across.
// Of the cross product each term is rounded by its own size. The part within the support is |v| < √(1 − ρ²), ρ =
// |across|, y = ρ² + v². The far end is the near one and the length: a relative error of the length moves an end where
// g is least.
//
// Circle: with ρ from the axis, x = ρ − R beside the circle and z above its plane, a point of it at the angle φ from
// the nearest is at the distance y = x² + z² + 4Rρ sin²(φ/2); poles of the window are where that is ε less. The radial
// part of its offset is x + 2R sin²(φ/2). Since sin(φ/2) ≥ φ/π, the distance grows along the arc Rφ at least as along a
// straight line that is (π/2)√(R/ρ) shorter.
#include "renderer/reference/reference_curves.h"

#include "renderer/reference/quadrature.h"
#include "renderer/reference/reference_skeleton.h"

#include <algorithm>

namespace isl::ISL_REFERENCE {
namespace {

Vector<Interval> unit_vector(const Vector<Interval>& v) { return v * (Interval(1) / square_root(squared_length(v))); }

Vector<Real> middles(const Vector<Interval>& v, Real unit) {
  return {v.x.middle() * unit, v.y.middle() * unit, v.z.middle() * unit};
}

/// The length of a vector of errors.
Size spread(const Vector<Interval>& v) { return std::hypot(v.x.radius(), v.y.radius(), v.z.radius()) * kStretch; }

}  // namespace

CurveOfSegment::CurveOfSegment(const scene::Component& c, Real unit)
    : a_(interval_of(c.a)), b_(interval_of(c.b)), unit_(unit) {
  const Vector<Interval> along = b_ - a_;
  const Interval length2 = squared_length(along);
  if (length2.lo() <= 0) return;
  length_ = sqrt(length2.middle()) * unit;
  axis_ = unit_vector(along);
}

CurveOfSegment::Place CurveOfSegment::place(const Vector<Interval>& p) const {
  const Vector<Interval> from_a = p - a_, from_b = p - b_;
  const Interval along_a = dot(from_a, axis_), along_b = dot(from_b, axis_);
  const bool is_near_a = abs(along_a.middle()) < abs(along_b.middle());
  const Interval along = is_near_a ? along_a : along_b;
  const Vector<Interval> across = cross(axis_, cross(is_near_a ? from_a : from_b, axis_));
  const Real near = -along.middle() * unit_;
  const Size size = Interval::size(unit_);
  // Far from both ends only the distance from the line counts.
  const bool sees_end = along.mignitude() * size < 1 + kPlaceRounding;
  return {is_near_a ? near : near - length_, is_near_a ? near + length_ : near, middles(across, unit_),
          std::hypot(spread(across), sees_end ? along.radius() : 0) * size * kStretch};
}

CurveIntegrals CurveOfSegment::integrals(const Place& at, const ReferenceWindow& window) const {
  const Real rho2 = squared_length(at.across), end = sqrt(std::max(1 - rho2, Real(0)));
  const Real from = std::max(at.from, -end), to = std::min(at.to, end);
  if (!(from < to)) return {};
  Real value = 0, fall = 0, along = 0;
  integrate(from, to, window.pole(rho2), [&](Real v, Real weight) {
    const ReferenceWindow::Values g = window.at(rho2 + v * v, (end - v) * (end + v));
    value += weight * g.value;
    fall += weight * g.fall;
    along += weight * g.fall * v;
  });
  return {value, fall, middles(axis_, 2 * along) - at.across * (2 * fall)};
}

ReferenceWindow::View CurveOfSegment::view(const Place&, Real, Real least) const {
  return {least, std::min(length_, 2 * sqrt(1 - least)), 1};
}

CurveOfCircle::CurveOfCircle(const scene::Component& c, Real unit)
    : centre_(interval_of(c.a)), axis_(unit_vector(interval_of(c.b))), unit_(unit), radius_(c.radius_b * unit) {}

CurveOfCircle::Place CurveOfCircle::place(const Vector<Interval>& p) const {
  const Vector<Interval> from = p - centre_, across = cross(axis_, cross(from, axis_));
  const Interval height = dot(from, axis_);
  const Vector<Real> middle = middles(across, unit_);
  const Real rho = sqrt(squared_length(middle));
  const Size rounding = std::hypot(spread(across), height.radius()) * Interval::size(unit_);
  return {rho, rho - radius_, height.middle() * unit_, rho > 0 ? middle * (1 / rho) : Vector<Real>{},
          (rounding + Interval::size(rho + radius_) * kPlaceRounding) * kStretch};
}

CurveIntegrals CurveOfCircle::integrals(const Place& at, const ReferenceWindow& window) const {
  const Real nearest = square(at.beside) + square(at.height), k = 4 * radius_ * at.rho;
  const bool is_whole = k <= 1 - nearest;
  const Real half = is_whole ? half_turn() / 2 : asin(sqrt((1 - nearest) / k));
  const Real pole = k > 0 ? 2 * asinh(window.pole(nearest) / sqrt(k)) : 8;
  Real value = 0, fall = 0, lag = 0;
  integrate(0, 2 * half, pole, [&](Real angle, Real weight) {
    const Real sine2 = square(sin(angle / 2)), y = nearest + k * sine2;
    // sin²(μ/2) − sin²(φ/2) = sin((μ + φ)/2) sin((μ − φ)/2)
    const Real to_border = is_whole ? 1 - y : k * sin(half + angle / 2) * sin(half - angle / 2);
    const ReferenceWindow::Values g = window.at(y, to_border);
    value += weight * g.value;
    fall += weight * g.fall;
    lag += weight * g.fall * (2 * sine2);
  });
  // The arcs to both sides, whose offsets along the circle cancel.
  const Real both = 2 * radius_;
  return {both * value, both * fall,
          (at.outwards * (at.beside * fall + radius_ * lag) + middles(axis_, at.height * fall)) * (-2 * both)};
}

ReferenceWindow::View CurveOfCircle::view(const Place& at, Real ball, Real least) const {
  const Real whole = 2 * half_turn() * radius_, rho = at.rho - ball;
  if (!(rho > 0)) return {least, whole, kUnbounded};
  const Real shorter = std::max(Real(1), half_turn() / 2 * sqrt(radius_ / rho));
  return {least, std::min(whole, 2 * sqrt(1 - least) * shorter), shorter};
}

}  // namespace isl::ISL_REFERENCE
