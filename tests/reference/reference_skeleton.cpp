#include "tests/reference/reference_skeleton.h"

#include "base/check.h"

#include <algorithm>
#include <cmath>

namespace isl::reference {

ReferenceSkeleton::ReferenceSkeleton(const scene::Component& component)
    : start_(interval_of(component.a)), radius_start_(component.radius_a) {
  ISL_CHECK(component.radius_a >= 0 && component.radius_b >= 0, "radii {} and {}", component.radius_a,
            component.radius_b);
  if (component.skeleton != scene::Skeleton::point) axis_ = interval_of(component.b) - start_;
  if (component.skeleton == scene::Skeleton::cone && component.radius_a != component.radius_b) {
    radius_step_ = Interval(component.radius_b) - radius_start_;
  }
  axis_squared_ = squared_length(axis_);
  const Vector<Interval> middle = start_ + axis_ * Interval(0.5L);
  bound_centre_ = {middle.x.middle(), middle.y.middle(), middle.z.middle()};
  half_length_ = std::sqrt(axis_squared_.hi) / 2;
  largest_radius_ = std::max(component.radius_a, component.skeleton == scene::Skeleton::cone ? component.radius_b : 0);
  has_axis_ = axis_squared_.lo > 0;
}

Interval ReferenceSkeleton::nearest(const Interval& foot, const Interval& rho_squared) const {
  const Interval apex_distance = radius(foot);
  if (apex_distance.lo > 0) {
    return clamped(foot + radius_step_ * rho_squared / (axis_squared_ * apex_distance), 0, 1);
  }
  if (apex_distance.hi <= 0) return radius_step_.lo > 0 ? 1 : 0;
  // Both sides of the apex: the less A, the nearer v* is to the larger end.
  const Interval least =
      clamped(foot + radius_step_ * rho_squared / (axis_squared_ * Interval(apex_distance.hi)), 0, 1);
  return radius_step_.lo > 0 ? Interval(least.lo, 1) : Interval(0, least.hi);
}

Interval ReferenceSkeleton::relative(const Interval& distance_squared, const Interval& v) const {
  const Interval radius_squared = square(radius(v));
  if (radius_squared.lo <= 0) return {0, kUnbounded};
  return distance_squared / radius_squared;
}

long double ReferenceSkeleton::reach(long double q) const {
  return (half_length_ + largest_radius_ * std::sqrt(q)) * (1 + 0x1p-50L);
}

Interval ReferenceSkeleton::nearest(const Vector<Interval>& w) const {
  if (!has_axis_) {
    // Concentric spheres: the larger one is the nearer everywhere.
    return radius_step_.lo > 0 ? 1 : 0;
  }
  const Interval along = foot(w);
  return nearest(along, squared_length(offset(w, along)));
}

}  // namespace isl::reference
