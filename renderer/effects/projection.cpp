// Cameras whose rays are parallel, bend with the angle, or are the scene's own (film/projections.h makes the rays).
#include "renderer/effects/effect.h"

#include <fmt/format.h>

namespace isl::render {
namespace {

/// In the order of scene::CameraKind.
constexpr std::string_view kProjections[] = {"perspective", "orthographic", "fisheye",   "ultra_wide_angle", "omnimax",
                                             "panoramic",   "cylinder",     "spherical", "user_defined"};

}  // namespace

Effect projection() {
  return {.name = "projection",
          .summary = "a camera other than `perspective`",
          .find =
              [](const SceneUse& use, Requests& requests, std::string_view& reason) {
                reason = "the camera is `perspective`";
                const std::optional<scene::Camera>& camera = use.database().camera;
                if (!camera || camera->kind == scene::CameraKind::perspective) return;
                requests.add(fmt::format("a camera with `{}`", kProjections[static_cast<std::size_t>(camera->kind)]),
                             camera->said_at[scene::CameraItem::kind], camera->origin);
              },
          // A perspective camera with the same vectors shows roughly the same.
          .leave_out =
              [](scene::Database& database) {
                if (database.camera) database.camera->kind = scene::CameraKind::perspective;
              }};
}

}  // namespace isl::render
