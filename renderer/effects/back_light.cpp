// Surfaces lit from behind: by the second `diffuse` of a finish, or, with `double_illuminate`, as from the front. The
// integrator computes the cosines (LightWork::cosines); this record tells when it has to.
#include "renderer/effects/requests.h"

namespace isl::render {

Effect back_light() {
  return {.name = "back_light",
          .summary = "surfaces lit from behind",
          .from_quality = 2,
          .find =
              [](const SceneUse& use, Requests& requests, std::string_view& reason) {
                reason = "no surface is lit from behind";
                for (const Use<scene::Finish>& finish : use.finishes()) {
                  if (finish.record->diffuse_back > 0)
                    requests.add("`diffuse` of light from behind", finish.record->said_at[scene::FinishItem::diffuse],
                                 finish.user);
                }
                for (const Use<scene::Object>& object : use.objects()) {
                  if (object.record->double_illuminate)
                    requests.add("`double_illuminate`", object.record->said_at[scene::ObjectItem::double_illuminate],
                                 object.user);
                }
              },
          .stages = {.back_light = true}};
}

}  // namespace isl::render
