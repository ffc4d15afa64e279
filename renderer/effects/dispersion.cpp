// Bodies whose index of refraction depends on the colour of the light: at the first surface of one, white light is
// parted into rays of `dispersion_samples` colours (transparency.cpp, shading/spectrum.h), which keep their colours
// from there on. This record tells when there are such bodies.
#include "renderer/effects/effect.h"

namespace isl::render {

Effect dispersion() {
  return {.name = "dispersion",
          .summary = "colours that refraction parts",
          .from_quality = 6,
          .find =
              [](const SceneUse& use, Requests& requests, std::string_view& reason) {
                reason = "no interior has a `dispersion` other than 1";
                for (const Use<scene::Interior>& interior : use.interiors()) {
                  if (interior.record->dispersion != 1) requests.add("`dispersion`", interior.user);
                }
              },
          .leave_out =
              [](scene::Database& database) {
                for (scene::Interior& interior : database.interiors) interior.dispersion = 1;
              }};
}

}  // namespace isl::render
