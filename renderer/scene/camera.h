// From where the picture is taken.
#pragma once

#include "renderer/scene/transform.h"

namespace isl::scene {

/// A perspective camera after look_at, angle and sky have been applied: the ray through image coordinates (u, v), u and
/// v from −½ to ½, right and up, goes along direction + u·right + v·up. The vectors carry their lengths.
struct Camera {
  Vec3 location{0, 0, 0};
  Vec3 direction{0, 0, 1};
  Vec3 right{4.0 / 3.0, 0, 0};
  Vec3 up{0, 1, 0};
};

}  // namespace isl::scene
