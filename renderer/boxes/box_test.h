// One ray against one box.
#pragma once

#include "renderer/scene/transform.h"

#include <ImathBox.h>

#include <algorithm>
#include <cmath>

namespace isl::render {

/// t of a plane is (plane − origin)·(1/direction), which three roundings move by less than 4 units of 2⁻⁵³ of itself.
/// Stretches are longer by more than that on both sides, so a ray that meets a box always meets it here too.
inline constexpr double kBoxEarlier = 1 - 0x1p-50, kBoxLater = 1 + 0x1p-50;

/// False only if no point of the ray up to t_max is in the box, whose sides may be infinite.
[[nodiscard]] inline bool may_meet(const Imath::Box3d& box, const scene::Vec3& origin, const scene::Vec3& direction,
                                   double t_max) {
  if (box.isEmpty()) return false;
  double enter = 0, leave = t_max;
  for (int axis = 0; axis < 3; ++axis) {
    const double by = 1 / direction[axis];
    if (!std::isfinite(by)) {
      if (!(box.min[axis] <= origin[axis] && origin[axis] <= box.max[axis])) return false;
      continue;
    }
    const double a = (box.min[axis] - origin[axis]) * by, b = (box.max[axis] - origin[axis]) * by;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter * kBoxEarlier <= leave * kBoxLater;
}

}  // namespace isl::render
