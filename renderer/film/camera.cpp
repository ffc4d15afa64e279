#include "renderer/film/camera.h"

#include <algorithm>

namespace isl::render {

double pixel_angle(const scene::Camera& camera, int width, int height,
                   std::shared_ptr<const CameraFunctions> functions) {
  const double across = camera.right.length() / width, along = camera.up.length() / height;
  switch (camera.kind) {
    case scene::CameraKind::perspective: return std::min(across, along) / camera.direction.length();
    case scene::CameraKind::orthographic: return std::min(across, along) / (1000 * camera.right.length());
    default: break;
  }
  // Measured between the middle and its neighbours; a chord is as long as its small angle.
  const Projection projection(camera, std::move(functions));
  RecurringAngles angles;
  const Vec3 middle = projection.ray({0, 0}, angles).direction;
  const double right = (projection.ray({1.0 / width, 0}, angles).direction - middle).length();
  const double up = (projection.ray({0, 1.0 / height}, angles).direction - middle).length();
  // A cylinder from whose axis parallel rays start has an angle on one side only.
  const double angle = std::min(right, up) > 0 ? std::min(right, up) : std::max(right, up);
  return camera.kind == scene::CameraKind::user_defined && angle == 0 ? 1.0 / (1000 * width) : angle;
}

}  // namespace isl::render
