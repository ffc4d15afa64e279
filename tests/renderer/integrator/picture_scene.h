// The scenes of povray_solids.pov and povray_blob.pov as databases, and a helper to build others.
#pragma once

#include "renderer/scene/database.h"

namespace isl::render::test {

/// Adds a solid with its own texture, placed by `world_from_object`.
void add_solid(scene::Database& database, const scene::Solid& solid, const scene::Colour& pigment,
               const scene::Finish& finish, const scene::Transform& world_from_object = {});

[[nodiscard]] scene::Database povray_solids();
[[nodiscard]] scene::Database povray_blob();

}  // namespace isl::render::test
