// Questions about a scene's lights that effects of light have in common.
#pragma once

#include "renderer/scene/light.h"

namespace isl::render {

[[nodiscard]] inline bool shines(const scene::Light& light) {
  return light.colour.red != 0 || light.colour.green != 0 || light.colour.blue != 0;
}

/// Fill lights throw no shadows and make no highlights.
[[nodiscard]] inline bool is_full(const scene::Light& light) { return shines(light) && !light.shadowless; }

}  // namespace isl::render
