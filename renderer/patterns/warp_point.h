// Maps the point at which a pattern is evaluated through transforms, warps and turbulence, for every kind of pattern.
#pragma once

#include "renderer/scene/database.h"

#include <algorithm>

namespace isl::render {

/// POV-Ray clips the coordinates of points that patterns are evaluated at.
[[nodiscard]] inline scene::Vec3 within_limit(const scene::Vec3& p) noexcept {
  constexpr double kLimit = 1e17;
  return {std::clamp(p.x, -kLimit, kLimit), std::clamp(p.y, -kLimit, kLimit), std::clamp(p.z, -kLimit, kLimit)};
}

/// `yes` if the pattern's `turbulence` moves the point too; some patterns use it in their formula instead.
enum class PointTurbulence { yes, no };

/// Maps a point of the space that the pattern is placed into to the pattern's own space: through the warps, the last
/// one first, and then through its turbulence. Degenerate warps (a torus of radius 0, the middle of a cube) give NaN,
/// as in POV-Ray.
[[nodiscard]] scene::Vec3 warped(const scene::Database& database, const scene::Pattern& pattern, scene::Vec3 point,
                                 PointTurbulence turbulence) noexcept;

}  // namespace isl::render
