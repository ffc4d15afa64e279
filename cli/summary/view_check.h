// Finds mistakes in the view of a scene before it is rendered: a blank picture explains nothing. Uses only the
// database; compiles nothing.
#pragma once

#include "cli/session/session.h"
#include "cli/summary/scene_extent.h"
#include "cli/summary/scene_summary.h"

namespace isl::cli {

/// Warns if the camera sees nothing, or if there is no light. Precondition: the session was evaluated, and `summary`
/// and `extent` are of its scene.
void warn_of_view(Session& session, const SceneSummary& summary, const SceneExtent& extent);

}  // namespace isl::cli
