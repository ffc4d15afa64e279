// Blur of what is out of focus. The sampler lets rays start on the lens (film/lens.h) if the plan has this effect.
#include "renderer/effects/effect.h"

namespace isl::render {

Effect focal_blur() {
  return {.name = "focal_blur",
          .summary = "blur outside the focus",
          .is_soft = true,
          .find =
              [](const SceneUse& use, Requests& requests, std::string_view& /*reason*/) {
                const std::optional<scene::Camera>& camera = use.database().camera;
                if (camera && camera->blur)
                  requests.add("focal blur", camera->said_at[scene::CameraItem::blur], camera->origin);
              },
          .leave_out =
              [](scene::Database& database) {
                if (database.camera) database.camera->blur.reset();
              }};
}

}  // namespace isl::render
