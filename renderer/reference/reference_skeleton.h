// The skeletons: the squared distance q to one relative to the squared radius, as docs/language.md defines it, of
// points that are functions of t. Knows nothing of kernels or blobs.
#pragma once

#include "renderer/reference/jet.h"
#include "renderer/scene/database.h"

#include <functional>
#include <optional>
#include <span>

namespace isl::ISL_REFERENCE {

[[nodiscard]] inline Vector<Real> exactly(const scene::Vec3& v) { return {v.x, v.y, v.z}; }
[[nodiscard]] inline Vector<Interval> interval_of(const scene::Vec3& v) {
  return {Interval(v.x), Interval(v.y), Interval(v.z)};
}

class ReferenceSkeleton {
 public:
  /// `corners` are the blob's.
  explicit ReferenceSkeleton(const scene::Component& component, std::span<const scene::Vec3> corners = {});

  /// q of points. Where q has no bound (the tip of a cone of radius zero), the range is everything.
  [[nodiscard]] Jet of(const Vector<Jet>& p) const { return distance_(p); }

  /// A sphere about bound_centre() with the radius reach(q) holds every point whose q is at most the given one.
  [[nodiscard]] const Vector<Real>& bound_centre() const { return centre_; }
  [[nodiscard]] Real reach(Real q) const { return (half_size_ + largest_radius_ * sqrt(q)) * kStretch; }

  struct Stretch {
    Real begin, end;
  };
  /// For a skeleton without end: the stretch of a line on which q passes between 0 and root_q², before and behind which
  /// it is constant or above; empty if begin = end.
  [[nodiscard]] std::optional<Stretch> change_on(const Line& line, Real root_q) const;

 private:
  std::function<Jet(const Vector<Jet>&)> distance_;
  Vector<Real> centre_{};
  Real half_size_ = 0, largest_radius_ = 0;
  /// Of a skeleton without end: a point of its plane and the normal.
  struct Plane {
    Vector<Interval> at, normal;
    bool has_two_sides;
  };
  std::optional<Plane> plane_;
};

}  // namespace isl::ISL_REFERENCE
