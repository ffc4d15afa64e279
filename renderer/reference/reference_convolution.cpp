#include "renderer/reference/reference_convolution.h"

#include "base/check.h"

#include <algorithm>

namespace isl::ISL_REFERENCE {
namespace {

Vector<Real> middle_of(const Vector<Jet>& p, Real unit) {
  return {p.x.value.middle() * unit, p.y.value.middle() * unit, p.z.value.middle() * unit};
}

}  // namespace

ReferenceConvolution::ReferenceConvolution(const scene::Component& component, const scene::Kernel& kernel)
    : window_(kernel), unit_(1 / (component.radius_a * sqrt(window_.border()))) {
  ISL_CHECK(component.skeleton == scene::Skeleton::segment || component.skeleton == scene::Skeleton::circle,
            "skeleton {}", static_cast<int>(component.skeleton));
  curve_ =
      component.skeleton == scene::Skeleton::segment ? segment_curve(component, unit_) : circle_curve(component, unit_);
}

Jet ReferenceConvolution::of(const Vector<Jet>& p, bool is_one_place) const {
  // The places are in a ball about their middle, to which belongs what rounding does to all distances from them.
  const Vector<Real> at = middle_of(p, unit_);
  const auto radius = [](const Jet& x) { return Real(x.value.radius()); };
  const Real half = sqrt(squared_length(Vector<Real>{radius(p.x), radius(p.y), radius(p.z)}));
  const Real rounding = (sqrt(squared_length(at)) + curve_.far + 1) * (16 * kRoundoff);
  const Real ball = half * unit_ * kStretch + rounding, distance = curve_.distance(at), nearest = distance - ball;
  if (nearest >= 1) return {};
  const Real least = nearest > 0 ? nearest * nearest : 0;
  const ReferenceWindow::Bounds bounds = window_.bounds(curve_.view(at, ball, least));
  const Interval amplitude(window_.amplitude()), unit(unit_);
  const Interval speed2 = (square(p.x.slope) + square(p.y.slope) + square(p.z.slope)) * square(unit);
  const Interval bend = bounds.bend * amplitude * speed2;
  if (!is_one_place) {
    const Size most_slope = (square_root(speed2) * amplitude).magnitude() * bounds.most_slope * kStretch;
    return {Interval(0, bounds.most_value) * amplitude, Interval::around(0, most_slope), bend};
  }
  Curve::Integrals sum{};
  if (distance < 1) sum = curve_.integrals(at, window_);
  const Size moved = Interval::size(ball), value_error = bounds.most_slope * moved +
                                                         Interval::size(sum.fall) * kPlaceRounding +
                                                         Interval::size(sum.value) * kIntegralRounding;
  const Size slope_error = bounds.bend.magnitude() * moved + bounds.most_slope * kIntegralRounding;
  const auto component = [&](Real g) { return Interval::around(g, slope_error * kStretch) * (amplitude * unit); };
  const auto value = Interval::around(sum.value, value_error * kStretch) * amplitude;
  return {value,
          component(sum.gradient.x) * p.x.slope + component(sum.gradient.y) * p.y.slope +
              component(sum.gradient.z) * p.z.slope,
          bend};
}

Real ReferenceConvolution::sensitivity(const Vector<Jet>& p) const {
  const Vector<Real> at = middle_of(p, unit_);
  return curve_.distance(at) < 1 ? curve_.integrals(at, window_).fall * window_.amplitude() : 0;
}

}  // namespace isl::ISL_REFERENCE
