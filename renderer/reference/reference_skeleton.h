// The squared distance q of a component, relative to the squared radius, in the component's space. Used by
// reference_field and reference_ray; must not know kernels or blobs, and leaves each skeleton's geometry to its form
// (skeleton_forms.h).
//
// If the skeleton is a convex set with the same radius everywhere, q is convex: its slope along a ray is monotone, so
// the slope's range is exact. Only the forms of cones and circles compute their own ranges.
#pragma once

#include "renderer/reference/interval.h"
#include "renderer/reference/skeleton_forms.h"
#include "renderer/scene/database.h"

#include <span>

namespace isl::ISL_REFERENCE {

[[nodiscard]] inline Vector<Real> exactly(const scene::Vec3& v) { return {v.x, v.y, v.z}; }

class ReferenceSkeleton {
 public:
  /// `corners` are the blob's.
  explicit ReferenceSkeleton(const scene::Component& component, std::span<const scene::Vec3> corners = {});

  /// q and ∇q at the points of a box. If q has no bound (the tip of a cone of radius zero), the range is everything.
  [[nodiscard]] RelativeDistance at(const Vector<Interval>& p) const { return form_->at(p); }
  [[nodiscard]] DistanceOnLine at(const Line& line, Real t) const;
  /// q and dq/dt over a stretch of a line.
  [[nodiscard]] DistanceOnLine over(const Stretch& stretch) const { return form_->over(stretch); }

  /// For a skeleton without end: the stretch of a line on which q passes between 0 and root_q².
  [[nodiscard]] std::optional<ChangeOnLine> change_on(const Line& line, Real root_q) const {
    return form_->change_on(line, root_q);
  }

  /// A sphere about bound_centre() with radius reach(q) holds every point whose q is at most the given one.
  [[nodiscard]] const Vector<Real>& bound_centre() const { return extent_.centre; }
  [[nodiscard]] Real reach(Real q) const;

 private:
  SkeletonFormHandle form_;
  SkeletonExtent extent_;
};

}  // namespace isl::ISL_REFERENCE
