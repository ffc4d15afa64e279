// Where a scene's surfaces are, and a camera that sees them: so that the first picture need not be blank. From the
// database alone; compiles nothing.
#pragma once

#include "renderer/scene/database.h"

#include <ImathBox.h>

#include <string>

namespace isl::cli {

struct SceneExtent {
  Imath::Box3d box;        ///< in world space; holds every bounded surface; empty when there is none
  bool unbounded = false;  ///< the scene has planes, or what may be without end, besides
};

[[nodiscard]] SceneExtent extent_of(const scene::Database& database);

/// `camera { … }` in the language, from the right, above and the front, with the whole box in the picture.
/// Precondition: the box is not empty.
[[nodiscard]] std::string suggest_camera(const Imath::Box3d& box);

/// False where the box lies wholly outside the camera's pyramid; true may still mean hidden. Of cameras that have no
/// pyramid nothing is known.
[[nodiscard]] bool may_see(const scene::Camera& camera, const Imath::Box3d& box);

}  // namespace isl::cli
