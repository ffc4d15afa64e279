// The point at which a pattern is evaluated, taken through transforms, warps and turbulence. Knows no pattern.
#pragma once

#include "renderer/scene/database.h"

namespace isl::render {

/// The pattern's `turbulence` moves the point too, or it does not; some patterns use it in ways of their own.
enum class PointTurbulence { yes, no };

/// The point of the pattern's own space for one of the space it is placed into: through the warps, the last one first,
/// and then through its turbulence. Degenerate warps (a torus without radius, the middle of a cube) give NaN as POV-Ray
/// does.
[[nodiscard]] scene::Vec3 warped(const scene::Database& database, const scene::Pattern& pattern, scene::Vec3 point,
                                 PointTurbulence turbulence) noexcept;

}  // namespace isl::render
