// What lights a scene.
#pragma once

#include "base/source_span.h"
#include "renderer/scene/colour.h"
#include "renderer/scene/transform.h"

namespace isl::scene {

/// A point light without fading.
struct Light {
  Vec3 location{0};
  Colour colour{1, 1, 1};
  bool shadowless = false;
  OriginId origin{};
};

}  // namespace isl::scene
