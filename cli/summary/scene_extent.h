// The extent of a scene's surfaces, and a camera that sees them, so that the first picture is not blank. Uses only the
// database; compiles nothing.
#pragma once

#include "renderer/scene/database.h"

#include <ImathBox.h>

#include <string>

namespace isl::cli {

struct SceneExtent {
  Imath::Box3d box;        ///< in world space; holds every bounded surface; empty when there is none
  bool unbounded = false;  ///< the scene also has planes, or other objects that may be infinite
};

[[nodiscard]] SceneExtent extent_of(const scene::Database& database);

/// `camera { … }` in the language, from the right, above and the front, with the whole box in the picture.
/// Precondition: the box is not empty.
[[nodiscard]] std::string suggest_camera(const Imath::Box3d& box);

/// False if the box lies wholly outside the camera's pyramid; a visible box may still be hidden. Always true for
/// cameras without a pyramid.
[[nodiscard]] bool may_see(const scene::Camera& camera, const Imath::Box3d& box);

}  // namespace isl::cli
