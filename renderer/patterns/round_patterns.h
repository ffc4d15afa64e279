// Patterns of distances and angles: rings, bands, spirals. A pattern that ends at distance 1 is 1 at its middle and 0
// beyond.
#pragma once

#include "renderer/scene/pattern.h"

namespace isl::render {

using scene::Vec3;

[[nodiscard]] double onion(const Vec3& p) noexcept;  ///< |p|
[[nodiscard]] double spherical(const Vec3& p) noexcept;
[[nodiscard]] double cylindrical(const Vec3& p) noexcept;  ///< about the y axis
[[nodiscard]] double boxed(const Vec3& p) noexcept;
[[nodiscard]] double planar(const Vec3& p) noexcept;  ///< from the plane y = 0
/// The angle about the y axis as a part of the turn, 1/4 on the axis itself.
[[nodiscard]] double radial(const Vec3& p) noexcept;
/// p · direction.
[[nodiscard]] double gradient(const Vec3& p, const Vec3& direction) noexcept;
/// ((sin x + sin y + sin z) / 3)².
[[nodiscard]] double leopard(const Vec3& p) noexcept;
/// In every unit cube, swelling from its middle by a Bézier curve of the distance with the two controls.
[[nodiscard]] double quilted(const Vec3& p, const scene::QuiltedOperands& operands) noexcept;
/// p.z + distance from the z axis + arms · angle about it, + turbulence.
[[nodiscard]] double spiral1(const Vec3& p, int arms, double turbulence) noexcept;
/// Two spirals that cross: triangle wave of the distance + triangle wave of spiral1.
[[nodiscard]] double spiral2(const Vec3& p, int arms, double turbulence) noexcept;

}  // namespace isl::render
