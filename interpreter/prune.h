// Drops the shapes that the scene declared and never placed: the database keeps only those that the world reaches.
#pragma once

#include "renderer/scene/database.h"

namespace isl::interpreter {

/// Removes unreachable blobs, solids, groups, textures and transforms, and renumbers the rest in their old order.
void prune(scene::Database& database);

}  // namespace isl::interpreter
