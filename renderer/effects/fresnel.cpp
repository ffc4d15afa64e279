// Reflection by Fresnel's formula: from the least reflectivity to the greatest by the share that a surface between the
// two media mirrors (shading/mirror.h). The integrator computes the ratio of their indices of refraction where this
// effect is called for.
#include "renderer/effects/light_requests.h"
#include "renderer/effects/requests.h"

namespace isl::render {

Effect fresnel() {
  return {
      .name = "fresnel",
      .summary = "reflection by the index of refraction",
      .from_quality = 8,
      .find = find_finishes("`fresnel` reflection", scene::FinishItem::fresnel_reflection,
                            [](const scene::Finish& finish) { return reflects(finish) && finish.fresnel_reflection; }),
      .stages = {.fresnel = true},
      .leave_out = [](scene::Database& database) {
        for (scene::Finish& finish : database.finishes) finish.fresnel_reflection = false;
      }};
}

}  // namespace isl::render
