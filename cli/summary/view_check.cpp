#include "cli/summary/view_check.h"

#include <fmt/format.h>

namespace isl::cli {

void warn_of_view(Session& session, const SceneSummary& summary, const SceneExtent& extent) {
  const scene::Database& database = session.scene().database;
  const bool has_bounds = !extent.box.isEmpty() && !extent.unbounded;
  if (has_bounds && !may_see(database.camera.value_or(scene::Camera{}), extent.box)) {
    const char* const message = database.camera ? "the camera sees nothing of the scene"
                                                : "there is no camera, and the default one sees nothing of the scene";
    session.sink().warning({}, message, fmt::format("this one sees it: {}", suggest_camera(extent.box)));
  }
  if (summary.primitives() > 0 && summary.lights == 0) {
    session.sink().warning({}, "the scene has no light_source: only ambient light is visible");
  }
}

}  // namespace isl::cli
