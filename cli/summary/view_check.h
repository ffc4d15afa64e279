// What is wrong with the view of a scene, told before it is rendered: a blank picture explains nothing. From the
// database alone; compiles nothing.
#pragma once

#include "cli/session/session.h"
#include "cli/summary/scene_extent.h"
#include "cli/summary/scene_summary.h"

namespace isl::cli {

/// Warns where the camera sees nothing, or where there is no light. Precondition: the session was evaluated, and
/// `summary` and `extent` are of its scene.
void warn_of_view(Session& session, const SceneSummary& summary, const SceneExtent& extent);

}  // namespace isl::cli
