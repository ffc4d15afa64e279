// The skeletons, one form each: the squared distance q to the skeleton relative to the squared radius, and its
// gradient, from the definition, over intervals. reference_skeleton uses the forms and has
// everything that they share; the forms must not know kernels or blobs.
#pragma once

#include "renderer/reference/interval.h"
#include "renderer/scene/database.h"

#include <memory>
#include <optional>
#include <span>

namespace isl::ISL_REFERENCE {

/// Stands for "any size at all" if a bound does not exist; far from overflow even after multiplications.
inline constexpr Real kUnbounded = 1e4000L;

[[nodiscard]] inline Vector<Interval> interval_of(const scene::Vec3& v) {
  return {Interval(v.x), Interval(v.y), Interval(v.z)};
}
[[nodiscard]] inline Vector<Interval> hull(const Vector<Interval>& a, const Vector<Interval>& b) {
  return {hull(a.x, b.x), hull(a.y, b.y), hull(a.z, b.z)};
}

/// A skeleton lies within `half_size` of `centre`, and its radius is nowhere above `largest_radius`.
struct SkeletonExtent {
  Vector<Real> centre;
  Real half_size, largest_radius;
};

/// q and ∇q.
struct RelativeDistance {
  Interval q;
  Vector<Interval> gradient;
};

/// A straight line in the component's space.
struct Line {
  Vector<Interval> origin, direction;

  [[nodiscard]] Vector<Interval> at(Real t) const { return origin + direction * Interval(t); }
};

/// q and dq/dt on a line.
struct DistanceOnLine {
  Interval q, slope;
};

/// A stretch of a line with q and dq/dt at its ends.
struct Stretch {
  Line line;
  Real t0, t1;
  DistanceOnLine first, last;

  /// t − t0, and t1 − t.
  [[nodiscard]] Interval steps() const { return {0, (Interval(t1) - Interval(t0)).hi}; }
};

/// The stretch of a line on which an endless field changes; before and behind it is constant. Empty if begin = end.
struct ChangeOnLine {
  Real begin, end;
};

/// The stretch on which a height above a plane that changes linearly, x + t·dx, is between `low` and `high`.
[[nodiscard]] ChangeOnLine change_between(const Interval& x, const Interval& dx, Real low, Real high);

class SkeletonForm {
 public:
  virtual ~SkeletonForm() = default;
  [[nodiscard]] virtual SkeletonExtent extent() const = 0;
  /// q and ∇q at the points of a box, which may be one point.
  [[nodiscard]] virtual RelativeDistance at(const Vector<Interval>& p) const = 0;
  /// q and dq/dt over a whole stretch. Forms whose skeleton is a convex set of one radius, so that q is convex, need
  /// not override it.
  [[nodiscard]] virtual DistanceOnLine over(const Stretch& stretch) const;
  /// For a skeleton without end: the stretch on which q passes between 0 and root_q². Empty for all others.
  [[nodiscard]] virtual std::optional<ChangeOnLine> change_on(const Line&, Real) const { return std::nullopt; }
};

using SkeletonFormHandle = std::shared_ptr<const SkeletonForm>;

/// The form of point, segment and cone.
[[nodiscard]] SkeletonFormHandle limb_form(const scene::Component& component);
[[nodiscard]] SkeletonFormHandle box_form(const scene::Component& component);
[[nodiscard]] SkeletonFormHandle triangle_form(const scene::Component& component, const scene::Vec3& third_corner);
[[nodiscard]] SkeletonFormHandle circle_form(const scene::Component& component);
[[nodiscard]] SkeletonFormHandle disc_form(const scene::Component& component);
/// The form of a half-space.
[[nodiscard]] SkeletonFormHandle plane_form(const scene::Component& component);
[[nodiscard]] SkeletonFormHandle sheet_form(const scene::Component& component);

/// A lower bound of a convex function on [t0, t1], from enclosures of its values and slopes at the ends: its value
/// where the tangents meet, or at the lowest end.
[[nodiscard]] Real convex_minimum(Real t0, Real t1, const DistanceOnLine& first, const DistanceOnLine& last);

}  // namespace isl::ISL_REFERENCE
