// The projections of cameras: the ray through a point of the picture.
#pragma once

#include "renderer/rays/ray.h"
#include "renderer/scene/camera.h"

namespace isl::render {

/// Image coordinates: from −½ to ½, u to the right and v up.
struct PicturePoint {
  double u = 0, v = 0;
};

/// A ray; its direction is zero where the projection shows nothing, so that it meets nothing.
struct ViewRay {
  Vec3 origin, direction;
};

/// The ray of a camera through a point of its picture. The direction has unit length. Formulas as in POV-Ray.
[[nodiscard]] ViewRay view_ray(const scene::Camera& camera, const PicturePoint& at);

/// The place at which the camera's `normal` bends this ray, in the units in which POV-Ray measures it: shares of the
/// picture, angles in radians, or lengths, as the kind of camera has them.
[[nodiscard]] PicturePoint bent_at(const scene::Camera& camera, const PicturePoint& at);

}  // namespace isl::render
