// Questions about lights and what shines that several effects ask.
#pragma once

#include "renderer/scene/colour.h"
#include "renderer/scene/light.h"

namespace isl::render {

[[nodiscard]] inline bool shines(const scene::Colour& colour) {
  return colour.red != 0 || colour.green != 0 || colour.blue != 0;
}

[[nodiscard]] inline bool shines(const scene::Light& light) { return shines(light.colour); }

/// Fill lights throw no shadows and make no highlights.
[[nodiscard]] inline bool is_full(const scene::Light& light) { return shines(light) && !light.shadowless; }

}  // namespace isl::render
