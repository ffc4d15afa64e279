// The point: q = |p − c|²/r². Its lanes along a ray are set up from the table's columns (lane_setup-inl.h).
#pragma once

#include "renderer/fields/skeletons/skeleton.h"

namespace isl::render {

struct Point {
  Vec3 centre;
  double inverse_radius2;

  [[nodiscard]] Foot nearest(const Vec3& p) const { return {p - centre, inverse_radius2}; }

  [[nodiscard]] QRange q_over(const Box& box) const {
    QRange range{0, 0};
    for (int axis = 0; axis < 3; ++axis) {
      const double below = box.min[axis] - centre[axis], above = centre[axis] - box.max[axis];
      const double nearest = std::max({below, above, 0.0});
      const double farthest = std::max(-below, -above);
      range.low += nearest * nearest;
      range.high += farthest * farthest;
    }
    return {range.low * inverse_radius2, range.high * inverse_radius2};
  }

  [[nodiscard]] double thickest() const { return 1 / std::sqrt(inverse_radius2); }
  [[nodiscard]] std::array<Reach, 2> reach(const Vec3& n) const {
    const Reach centre_only{n.dot(centre), thickest()};
    return {centre_only, centre_only};
  }
};

}  // namespace isl::render
