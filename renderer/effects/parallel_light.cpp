// Parallel light, as from the sun. The sampler of lights (shading/lighting.h) makes its direction and distance.
#include "renderer/effects/requests.h"

namespace isl::render {

Effect parallel_light() {
  return {.name = "parallel",
          .summary = "light in one direction",
          .from_quality = 2,
          .find = find_lights("`parallel`", scene::LightItem::parallel,
                              [](const scene::Light& light) { return light.parallel; }),
          .leave_out = change_lights([](scene::Light& light) { light.parallel = false; })};
}

}  // namespace isl::render
