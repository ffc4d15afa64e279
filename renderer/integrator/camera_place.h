// Finds the bodies around the camera, such as water or the air of a room. A path that begins there leaves these bodies
// without having entered them.
#pragma once

#include "renderer/paths/bodies.h"
#include "renderer/scene/database.h"
#include "renderer/trace/tracer.h"

#include <vector>

namespace isl::render {

/// True if the camera stands in something that keeps media out. When the steps are spent, the answer is meaningless.
[[nodiscard]] bool is_camera_in_solid(const scene::Database& database, StepCounter& steps);

/// The bodies that the camera stands in, in the order in which they count as entered. As in POV-Ray, those that go on
/// without end come first, and the others in the order of its tree of boxes; beyond four objects that is only the order
/// at the top of the tree. The tracer's database is `database`. Steps as above.
[[nodiscard]] std::vector<Body> bodies_around_camera(const scene::Database& database, const Tracer& tracer,
                                                     StepCounter& steps);

}  // namespace isl::render
