#include "cli/summary/view_check.h"

#include <fmt/format.h>

#include <algorithm>

namespace isl::cli {

void warn_of_view(Session& session, const SceneSummary& summary, const SceneExtent& extent) {
  const scene::Database& database = session.scene().database;
  const bool has_bounds = !extent.box.isEmpty() && !extent.unbounded;
  if (has_bounds && !may_see(database.camera.value_or(scene::Camera{}), extent.box)) {
    const char* const message = database.camera ? "the camera sees nothing of the scene"
                                                : "there is no camera, and the default one sees nothing of the scene";
    session.sink().warning({}, message, fmt::format("this one sees it: {}", suggest_camera(extent.box)));
  }
  // The blocks of `global_settings` that are kept as statements are those of light from all around.
  const bool has_light_around =
      std::ranges::any_of(database.statements, [](const scene::Statement& block) { return block.kind->is_setting; });
  if (summary.primitives() > 0 && summary.lights == 0 && !has_light_around) {
    session.sink().warning({}, "the scene has no light_source: only ambient light is visible");
  }
}

}  // namespace isl::cli
