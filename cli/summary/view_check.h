// Finds mistakes in the view of a scene: a blank picture explains nothing. Uses only the database; compiles nothing.
#pragma once

#include "cli/session/session.h"
#include "cli/summary/scene_extent.h"
#include "cli/summary/scene_summary.h"
#include "renderer/image/image.h"

#include <string>

namespace isl::cli {

/// Warns if the camera sees nothing, or if there is no light. Precondition: the session was evaluated, and `summary`
/// and `extent` are of its scene.
void warn_of_view(Session& session, const SceneSummary& summary, const SceneExtent& extent);

/// "the picture is black: the camera is inside an object"; empty if a pixel has light, or the background is
/// transparent.
[[nodiscard]] std::string black_line(const scene::Database& database, const render::Image& image);

}  // namespace isl::cli
