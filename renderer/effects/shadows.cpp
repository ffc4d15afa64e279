// Shadows: light counts only if nothing stands in its way. The queue of shadow rays belongs to the integrator
// (paths/shadow_queue.h); this record tells when there is one.
#include "renderer/effects/effect.h"
#include "renderer/effects/light_requests.h"

#include <vector>

namespace isl::render {
namespace {

/// True if some object of the world throws a shadow. Each group is looked at once, from a list, so that neither depth
/// nor groups that hold a group twice cost more than their records.
bool has_occluder(const scene::Database& database) {
  std::vector<bool> is_listed(database.groups.size());
  std::vector<const std::vector<scene::Object>*> pending{&database.objects};
  while (!pending.empty()) {
    const std::vector<scene::Object>& objects = *pending.back();
    pending.pop_back();
    for (const scene::Object& object : objects) {
      if (object.no_shadow) continue;
      if (object.kind != scene::Object::Kind::group) return true;
      if (is_listed[object.shape]) continue;
      is_listed[object.shape] = true;
      pending.push_back(&database.groups[object.shape].children);
    }
  }
  return false;
}

}  // namespace

Effect shadows() {
  return {.name = "shadows",
          .summary = "objects that block light",
          .from_quality = 4,
          .find =
              [](const SceneUse& use, Requests& requests, std::string_view& reason) {
                reason = "no object throws a shadow";
                if (!has_occluder(use.database())) return;
                reason = "no light throws shadows";
                for (const Use<scene::Light>& light : use.lights()) {
                  if (is_full(*light.record)) requests.add("a light that throws shadows", light.user);
                }
              },
          .stages = {.shadows = true}};
}

}  // namespace isl::render
