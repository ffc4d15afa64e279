// Area lights whose points are at random places (shading/area_points.h). The integrator takes them where a light has
// `jitter`; this record tells when one has.
#include "renderer/effects/requests.h"

namespace isl::render {

Effect jitter() {
  return {.name = "jitter",
          .summary = "area lights whose points are at random places",
          .from_quality = 5,
          .is_soft = true,
          .find = find_lights("`jitter` of an area light", scene::LightItem::jitter,
                              [](const scene::Light& light) { return light.area && light.area->jitter; }),
          .leave_out = change_lights([](scene::Light& light) {
            if (light.area) light.area->jitter = false;
          })};
}

}  // namespace isl::render
