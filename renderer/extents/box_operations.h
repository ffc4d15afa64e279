// Boxes put together and moved, where a side may be infinite.
#pragma once

#include "renderer/scene/transform.h"

#include <ImathBox.h>

#include <algorithm>

namespace isl::render {

/// The intersection of two boxes; empty if they do not meet.
[[nodiscard]] inline Imath::Box3d common_box(const Imath::Box3d& a, const Imath::Box3d& b) {
  Imath::Box3d result;
  for (int i = 0; i < 3; ++i) {
    result.min[i] = std::max(a.min[i], b.min[i]);
    result.max[i] = std::min(a.max[i], b.max[i]);
    if (result.min[i] > result.max[i]) return {};
  }
  return result;
}

/// A box that contains the image of the box. An infinite side makes every side infinite on which it has an influence.
[[nodiscard]] inline Imath::Box3d box_through(const scene::Transform& transform, const Imath::Box3d& box) {
  if (box.isEmpty()) return {};
  Imath::Box3d result;
  for (int i = 0; i < 3; ++i) {
    result.min[i] = result.max[i] = transform.matrix[3][i];
    for (int j = 0; j < 3; ++j) {
      const double factor = transform.matrix[j][i];
      if (factor == 0) continue;  // 0 times an infinite side would be NaN
      result.min[i] += std::min(factor * box.min[j], factor * box.max[j]);
      result.max[i] += std::max(factor * box.min[j], factor * box.max[j]);
    }
  }
  return result;
}

}  // namespace isl::render
