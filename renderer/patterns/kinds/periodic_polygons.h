// Convex polygons that cover the plane of x and z and repeat along two directions: the regular and half-regular ways to
// cover it, and some of squares, bricks and rhombs.
#pragma once

#include "renderer/scene/transform.h"

namespace isl::render {

inline constexpr int kPolygonPlans = 24;

/// (kind + 1 − min(d / reach, 1)) / kinds, where d is the distance from the polygon's border. `plan` is from 1 to
/// kPolygonPlans.
[[nodiscard]] double periodic_polygons(int plan, const scene::Vec3& p) noexcept;

}  // namespace isl::render
