#include "renderer/reference/reference_convolution.h"

#include "base/check.h"

namespace isl::ISL_REFERENCE {
namespace {

/// The points' middle, without an error, and how far the points are from it.
struct Ball {
  Vector<Interval> centre;
  Size radius;

  explicit Ball(const Vector<Jet>& p)
      : centre{p.x.value.middle(), p.y.value.middle(), p.z.value.middle()},
        radius(std::hypot(p.x.value.radius(), p.y.value.radius(), p.z.value.radius()) * kStretch) {}
};

/// Bounds around a place, within a ball in units of the support.
template <class Curve>
struct Surroundings {
  typename Curve::Place place;
  Real distance;
  Size ball;
  ReferenceWindow::Bounds bounds;
  bool is_outside = false;

  Surroundings(const Curve& curve, const ReferenceWindow& window, const Ball& points, Real unit)
      : place(curve.place(points.centre)), distance(place.distance()) {
    // The rounding of the unit is that of all distances, of which no more than one support counts.
    ball = (points.radius * Interval::size(unit) + place.rounding + kPlaceRounding) * kStretch;
    const Real nearest = distance - ball;
    is_outside = nearest >= 1;
    if (!is_outside) bounds = window.bounds(curve.view(place, ball, nearest > 0 ? nearest * nearest : Real(0)));
  }
};

Interval squared_speed(const Vector<Jet>& p, Real unit) {
  return (square(p.x.slope) + square(p.y.slope) + square(p.z.slope)) * square(Interval(unit));
}

std::variant<CurveOfSegment, CurveOfCircle> curve_of(const scene::Component& component, Real unit) {
  const bool is_segment = component.skeleton == scene::Skeleton::segment;
  ISL_CHECK(is_segment || component.skeleton == scene::Skeleton::circle, "skeleton {}",
            static_cast<int>(component.skeleton));
  if (is_segment) return CurveOfSegment(component, unit);
  return CurveOfCircle(component, unit);
}

}  // namespace

ReferenceConvolution::ReferenceConvolution(const scene::Component& component, const scene::Kernel& kernel)
    : window_(kernel), unit_(1 / (component.radius_a * sqrt(window_.border()))), curve_(curve_of(component, unit_)) {}

Jet ReferenceConvolution::at(const Vector<Jet>& p) const {
  const auto on_curve = [&](const auto& curve) -> Jet {
    const Surroundings around(curve, window_, Ball(p), unit_);
    if (around.is_outside) return {};
    const ReferenceWindow::Bounds& bounds = around.bounds;
    CurveIntegrals sum{};
    if (around.distance < 1) sum = curve.integrals(around.place, window_);
    const Size value_error = bounds.most_slope * around.ball + Interval::size(sum.fall) * kPlaceRounding +
                             Interval::size(sum.value) * kIntegralRounding;
    // The place is off, and so are the axes along which the gradient is told, across which it grows by the bend, too.
    const Size slope_error = 2 * bounds.bend.magnitude() * around.ball + bounds.most_slope * kIntegralRounding;
    const Interval amplitude(window_.amplitude());
    const auto slope = [&](Real g, const Jet& coordinate) {
      return Interval::around(g, slope_error * kStretch) * (amplitude * Interval(unit_)) * coordinate.slope;
    };
    return {Interval::around(sum.value, value_error * kStretch) * amplitude,
            slope(sum.gradient.x, p.x) + slope(sum.gradient.y, p.y) + slope(sum.gradient.z, p.z),
            bounds.bend * amplitude * squared_speed(p, unit_)};
  };
  return std::visit(on_curve, curve_);
}

ReferenceConvolution::Bounds ReferenceConvolution::over(const Vector<Jet>& p) const {
  const auto on_curve = [&](const auto& curve) -> Bounds {
    const Surroundings around(curve, window_, Ball(p), unit_);
    if (around.is_outside) return {};
    const ReferenceWindow::Bounds& bounds = around.bounds;
    const Interval amplitude(window_.amplitude()), speed2 = squared_speed(p, unit_);
    const Size most_slope = (square_root(speed2) * amplitude).magnitude() * bounds.most_slope * kStretch;
    const Interval least = amplitude * Interval(window_.least(around.distance + around.ball, curve.longer_side()));
    return {
        {Interval(0, bounds.most_value) * amplitude, Interval::around(0, most_slope), bounds.bend * amplitude * speed2},
        least.lo()};
  };
  return std::visit(on_curve, curve_);
}

Real ReferenceConvolution::sensitivity(const Vector<Jet>& p) const {
  const auto on_curve = [&](const auto& curve) {
    const auto place = curve.place(Ball(p).centre);
    return place.distance() < 1 ? curve.integrals(place, window_).fall * window_.amplitude() : Real(0);
  };
  return std::visit(on_curve, curve_);
}

}  // namespace isl::ISL_REFERENCE
