// The light that one light source adds to a point if nothing is in between: the terms of shading/lighting.h, put
// together as in pictures.
#pragma once

#include "renderer/shading/lighting.h"

namespace isl::render::test {

[[nodiscard]] inline Rgb lit_by(const scene::Light& light, const ShadingPoint& point) {
  const LightSample sample = sample_light(light, point.position);
  const double incidence = point.normal.dot(sample.direction);
  if (!(incidence > 0)) return Rgb(0);
  Rgb colour = diffuse_colour(point, incidence);
  if (!light.shadowless) {
    const HighlightAngles angle = highlight_angles(point.normal, point.view, sample.direction);
    for (const LitTexture& lit : point.textures)
      colour += lit.let_through * (highlight(*lit.material, angle) * lit.weight);
  }
  return colour * rgb(light.colour);
}

}  // namespace isl::render::test
