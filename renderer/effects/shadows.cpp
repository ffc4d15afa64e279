// Shadows: light counts only if nothing stands in its way. The queue of shadow rays belongs to the integrator
// (paths/shadow_queue.h); this record tells when there is one.
#include "renderer/effects/effect.h"
#include "renderer/effects/light_requests.h"

#include <algorithm>

namespace isl::render {
namespace {

bool can_throw_shadow(const scene::Database& database, const scene::Object& object) {
  if (object.no_shadow) return false;
  if (object.kind != scene::Object::Kind::group) return true;
  const std::vector<scene::Object>& children = database.groups[object.shape].children;
  return std::ranges::any_of(children, [&](const scene::Object& child) { return can_throw_shadow(database, child); });
}

}  // namespace

Effect shadows() {
  return {.name = "shadows",
          .summary = "objects that block light",
          .from_quality = 4,
          .find =
              [](const SceneUse& use, Requests& requests, std::string_view& reason) {
                const scene::Database& database = use.database();
                reason = "no object throws a shadow";
                const bool has_occluder = std::ranges::any_of(
                    database.objects, [&](const scene::Object& object) { return can_throw_shadow(database, object); });
                if (!has_occluder) return;
                reason = "no light throws shadows";
                for (const Use<scene::Light>& light : use.lights()) {
                  if (is_full(*light.record)) requests.add("a light that throws shadows", light.user);
                }
              },
          .stages = {.shadows = true}};
}

}  // namespace isl::render
