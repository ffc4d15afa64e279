// The part of a database that one object needs, so that a shape can be made ready for rays without the rest of the
// scene.
#pragma once

#include "renderer/scene/database.h"

namespace isl::render {

/// A database with nothing in it but `object`, standing in its own space, as seen by rays alone: without what it looks
/// like, and without the flags that hide it from some rays.
[[nodiscard]] scene::Database subset(const scene::Database& database, const scene::Object& object);

}  // namespace isl::render
