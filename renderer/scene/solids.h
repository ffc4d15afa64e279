// Plain solids, each in the space in which the scene describes it.
#pragma once

#include "renderer/scene/transform.h"

#include <cstdint>

namespace isl::scene {

/// sphere: centre a, radius_a. cylinder: a to b, radius_a, with flat caps. cone: a, radius_a to b, radius_b, flat caps.
/// plane: the half-space p·a ≤ radius_a, a normalised.
enum class SolidKind : std::uint8_t { sphere, cylinder, cone, plane };

struct Solid {
  SolidKind kind = SolidKind::sphere;
  bool open = false;  ///< cylinder and cone: without caps
  Vec3 a{0}, b{0};
  double radius_a = 0, radius_b = 0;
};

}  // namespace isl::scene
