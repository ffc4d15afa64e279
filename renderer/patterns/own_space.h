// The own space of a pattern: points are taken into it by warps and turbulence, normals by the transforms among the
// warps alone, as in POV-Ray.
#pragma once

#include "renderer/scene/database.h"
#include "renderer/values/function_machine.h"

namespace isl::render {

/// The point in the pattern's own space.
[[nodiscard]] scene::Vec3 own_point(const scene::Database& database, const scene::Pattern& pattern,
                                    const scene::Vec3& point, const values::Environment& environment) noexcept;

/// Normals keep what the transforms do to their lengths.
[[nodiscard]] scene::Vec3 into_own_space(const scene::Database& database, const scene::Pattern& pattern,
                                         scene::Vec3 normal) noexcept;
[[nodiscard]] scene::Vec3 out_of_own_space(const scene::Database& database, const scene::Pattern& pattern,
                                           scene::Vec3 normal) noexcept;

}  // namespace isl::render
