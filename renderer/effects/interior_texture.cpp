// Another texture on the inside of a surface. The tracer gives it to points whose normal points away from the viewer
// (Tracer::surface_at); this record tells when there is one.
#include "renderer/effects/effect.h"

namespace isl::render {

Effect interior_texture() {
  const auto leave_out = [](std::vector<scene::Object>& objects) {
    for (scene::Object& object : objects) object.interior_texture = scene::kNoTexture;
  };
  return {.name = "interior_texture",
          .summary = "another texture on the inside of a surface",
          .find =
              [](const SceneUse& use, Requests& requests, std::string_view& reason) {
                reason = "no object has an `interior_texture`";
                for (const Use<scene::Object>& object : use.objects()) {
                  if (object.record->interior_texture == scene::kNoTexture) continue;
                  requests.add("`interior_texture`", object.record->said_at[scene::ObjectItem::interior_texture],
                               object.user);
                }
              },
          .leave_out =
              [leave_out](scene::Database& database) {
                leave_out(database.objects);
                for (scene::Group& group : database.groups) leave_out(group.children);
              }};
}

}  // namespace isl::render
