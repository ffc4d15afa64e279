// Lights with an area, which throw soft shadows: the shadow at a point is a mean over the points of the light's grid
// (shading/area_grid.h), and with `area_illumination` the light comes from each of them. The integrator and
// paths/area_shadows.cpp do so where a light has an area; this record tells when there is one.
#include "renderer/effects/requests.h"

namespace isl::render {

Effect area_light() {
  return {.name = "area_light",
          .summary = "lights with an area, which throw soft shadows",
          .from_quality = 5,
          .find = find_lights("`area_light`", scene::LightItem::area,
                              [](const scene::Light& light) { return light.area.has_value(); }),
          .leave_out = change_lights([](scene::Light& light) { light.area.reset(); })};
}

}  // namespace isl::render
