// Patterns that choose from a list: the number of the item, from 0 on.
#pragma once

#include "renderer/scene/pattern.h"

namespace isl::render {

using scene::Vec3;

/// Unit cubes, 0 and 1 in turn.
[[nodiscard]] double checker(const Vec3& p) noexcept;
/// 1 in a brick, 0 in the mortar. Layers of bricks along y, every other one moved by half a brick.
[[nodiscard]] double brick(const Vec3& p, const scene::BrickOperands& operands) noexcept;
/// By the axis to which the point is nearest: x, y, z, −x, −y, −z.
[[nodiscard]] double cubic(const Vec3& p) noexcept;
/// Regular hexagons of side 1 in the plane of x and z, no two neighbours equal.
[[nodiscard]] double hexagon(const Vec3& p) noexcept;
/// Unit squares in the plane of x and z.
[[nodiscard]] double square(const Vec3& p) noexcept;
/// Triangles of side 1 in the plane of x and z.
[[nodiscard]] double triangular(const Vec3& p) noexcept;

}  // namespace isl::render
