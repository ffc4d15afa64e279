#include "renderer/reference/reference_skeleton.h"

#include "base/check.h"

#include <algorithm>

namespace isl::ISL_REFERENCE {
namespace {

SkeletonFormHandle form_of(const scene::Component& component, std::span<const scene::Vec3> corners) {
  ISL_CHECK(component.radius_a >= 0 && component.radius_b >= 0, "radii {} and {}", component.radius_a,
            component.radius_b);
  switch (component.skeleton) {
    case scene::Skeleton::point:
    case scene::Skeleton::segment:
    case scene::Skeleton::cone: return limb_form(component);
    case scene::Skeleton::box: return box_form(component);
    case scene::Skeleton::triangle:
      ISL_CHECK(component.corner < corners.size(), "corner {} of {}", component.corner, corners.size());
      return triangle_form(component, corners[component.corner]);
    case scene::Skeleton::circle: return circle_form(component);
    case scene::Skeleton::disc: return disc_form(component);
    case scene::Skeleton::plane: return plane_form(component);
    case scene::Skeleton::sheet: return sheet_form(component);
  }
  ISL_CHECK(false, "skeleton {}", static_cast<int>(component.skeleton));
}

}  // namespace

ReferenceSkeleton::ReferenceSkeleton(const scene::Component& component, std::span<const scene::Vec3> corners)
    : form_(form_of(component, corners)), extent_(form_->extent()) {}

DistanceOnLine ReferenceSkeleton::at(const Line& line, Real t) const {
  const RelativeDistance here = at(line.at(t));
  return {here.q, dot(here.gradient, line.direction)};
}

Real ReferenceSkeleton::reach(Real q) const {
  return (extent_.half_size + extent_.largest_radius * sqrt(q)) * (1 + 0x1p-50L);
}

DistanceOnLine SkeletonForm::over(const Stretch& stretch) const {
  const DistanceOnLine &first = stretch.first, &last = stretch.last;
  const Real least = convex_minimum(stretch.t0, stretch.t1, first, last);
  return {{std::max(least, Real(0)), std::max(first.q.hi, last.q.hi)},
          {first.slope.lo, std::max(first.slope.lo, last.slope.hi)}};
}

ChangeOnLine change_between(const Interval& x, const Interval& dx, Real low, Real high) {
  if (dx.middle() == 0) return {0, 0};
  // If rounding hides the line's slope, the middle's is taken: a stretch without end could not be searched.
  const Interval slope = dx.sign() != 0 ? dx : Interval(dx.middle());
  const auto t_at = [&](Real height) {
    const Interval way = Interval(height) - x;
    return slope.sign() > 0 ? way / slope : -way / -slope;
  };
  return slope.sign() > 0 ? ChangeOnLine{t_at(low).lo, t_at(high).hi} : ChangeOnLine{t_at(high).lo, t_at(low).hi};
}

Real convex_minimum(Real t0, Real t1, const DistanceOnLine& first, const DistanceOnLine& last) {
  if (first.slope.lo >= 0) return first.q.lo;
  if (last.slope.hi <= 0) return last.q.lo;
  const Real h = t1 - t0;
  const Real s =
      std::clamp((first.q.lo - last.q.lo + last.slope.hi * h) / (last.slope.hi - first.slope.lo), Real(0), h);
  // The function lies above the falling tangent to the left of t0 + s, and above the rising one to the right: any s
  // gives a bound.
  const Interval left = Interval(first.q.lo) + Interval(first.slope.lo) * Interval(s);
  const Interval right = Interval(last.q.lo) - Interval(last.slope.hi) * (Interval(h) - Interval(s));
  return std::min(left.lo, right.lo);
}

}  // namespace isl::ISL_REFERENCE
