// The default camera, which scenes without a camera use and the items of a `camera` block modify.
#pragma once

#include "renderer/scene/camera.h"

namespace isl::scene {

/// POV-Ray's `right` has length 1.33, which suits pictures of 4:3. Here it follows the picture's aspect ratio, so that
/// no picture is stretched.
[[nodiscard]] inline Camera default_camera(int width, int height) {
  constexpr double kRight = 1.33, kShape = 4.0 / 3.0;
  const double shape = static_cast<double>(width) / static_cast<double>(height);
  return {.right = Vec3(kRight * (shape / kShape), 0, 0)};
}

}  // namespace isl::scene
