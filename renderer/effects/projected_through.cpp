// Light that shines only through an object. paths/light_windows.h shortens the rays to such lights; this record tells
// when there are some.
#include "renderer/effects/requests.h"
#include "renderer/paths/light_windows.h"

namespace isl::render {

Effect projected_through() {
  return {.name = "projected_through",
          .summary = "light that shines only through an object",
          .from_quality = 2,
          .find = find_lights("`projected_through`", scene::LightItem::projected_through, LightWindows::has_window),
          .stages = {.windows = true}};
}

}  // namespace isl::render
