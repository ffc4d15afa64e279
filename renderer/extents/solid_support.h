// How far a solid reaches in a direction: the support function of convex geometry, from which a box in any space
// follows. Knows every solid of the language, whether it can be drawn or not.
#pragma once

#include "renderer/scene/database.h"

#include <ImathBox.h>

namespace isl::render {

using Box = Imath::Box3d;

/// The greatest direction · p over the solid, in its own space; infinite where it has no end that way, and where none
/// is known (cubic, quartic, poly). Exact for all others, rounding aside. `direction` may have any length but zero.
[[nodiscard]] double support(const scene::Database& database, const scene::Solid& solid, const scene::Vec3& direction);

/// The box of the solid after a map, tight where `support` is exact; its sides may be infinite.
[[nodiscard]] Box box_of(const scene::Database& database, const scene::Solid& solid,
                         const scene::Transform& world_from_solid);

}  // namespace isl::render
