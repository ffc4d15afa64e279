// The part of a database that one object needs, so that a shape can be made ready for rays without the rest of the
// scene.
#pragma once

#include "renderer/scene/database.h"

namespace isl::render {

/// A database that holds only `object`, in the object's own space, for rays alone: without textures, and without the
/// flags that hide it from some rays.
[[nodiscard]] scene::Database subset(const scene::Database& database, const scene::Object& object);

}  // namespace isl::render
