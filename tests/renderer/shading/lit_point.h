// The light that one light source adds to a point if nothing is in between: the terms of shading/lighting.h, put
// together as in pictures.
#pragma once

#include "renderer/shading/highlights.h"
#include "renderer/shading/lighting.h"

namespace isl::render::test {

[[nodiscard]] inline Rgb lit_by(const scene::Light& light, const ShadingPoint& point) {
  const LightSample sample = sample_light(light, point.position);
  const double incidence = point.normal.dot(sample.direction);
  if (!(incidence > 0)) return Rgb(0);
  Rgb colour = diffuse_colour(point, incidence);
  if (!light.shadowless) {
    for (const LitTexture& lit : point.textures) {
      Rgb shine(0);
      Highlights highlights;
      highlights.add(*lit.material, point.normal, point.view, sample.direction, shine);
      highlights.finish();
      colour += lit.let_through * (shine * lit.weight);
    }
  }
  return colour * rgb(light.colour);
}

}  // namespace isl::render::test
