// A point of the picture, and the ray through it.
#pragma once

#include "renderer/scene/transform.h"

namespace isl::render {

using scene::Vec3;

/// Image coordinates: from −½ to ½, u to the right and v up.
struct PicturePoint {
  double u = 0, v = 0;
};

/// A ray; its direction is zero where the projection shows nothing, so that it meets nothing.
struct ViewRay {
  Vec3 origin, direction;
};

}  // namespace isl::render
