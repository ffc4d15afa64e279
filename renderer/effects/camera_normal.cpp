// Bumps that bend the camera's rays (film/camera_bumps.h). The sampler bends the rays; this record tells when.
#include "renderer/effects/effect.h"

namespace isl::render {

Effect camera_normal() {
  return {.name = "camera_normal",
          .summary = "bumps that bend the camera's rays",
          .find =
              [](const SceneUse& use, Requests& requests, std::string_view& reason) {
                reason = "the camera has no `normal`";
                const std::optional<scene::Camera>& camera = use.database().camera;
                if (camera && camera->normal != scene::kNoNormal)
                  requests.add("`normal` of a camera", camera->said_at[scene::CameraItem::normal], camera->origin);
              },
          .leave_out =
              [](scene::Database& database) {
                if (database.camera) database.camera->normal = scene::kNoNormal;
              }};
}

}  // namespace isl::render
