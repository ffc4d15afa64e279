// The camera of a scene without one, and what a camera's items change.
#pragma once

#include "renderer/scene/camera.h"

namespace isl::scene {

/// POV-Ray's `right` has length 1.33, which suits pictures of 4:3; here it follows the shape of the picture, so that
/// none is stretched.
[[nodiscard]] inline Camera default_camera(int width, int height) {
  constexpr double kRight = 1.33, kShape = 4.0 / 3.0;
  const double shape = static_cast<double>(width) / static_cast<double>(height);
  return {.right = Vec3(kRight * (shape / kShape), 0, 0)};
}

}  // namespace isl::scene
