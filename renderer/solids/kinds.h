// The solids one by one, for the dispatch in solid.cpp only; contracts as in solid.h, which everyone else includes.
#pragma once

#include "renderer/solids/solid.h"

namespace isl::render {

/// The surface of a sphere or plane, and the side of a cylinder or cone.
inline constexpr std::uint8_t kSide = 0;
/// The flat ends of cylinders and cones, at Solid::a and at Solid::b.
inline constexpr std::uint8_t kCapA = 1;
inline constexpr std::uint8_t kCapB = 2;

[[nodiscard]] Crossings sphere_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                                         std::uint8_t start_part) noexcept;
[[nodiscard]] Vec3 sphere_normal(const scene::Solid& solid, const Vec3& point) noexcept;
[[nodiscard]] Box sphere_bounds(const scene::Solid& solid) noexcept;

[[nodiscard]] Crossings cylinder_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                                           std::uint8_t start_part) noexcept;
[[nodiscard]] Vec3 cylinder_normal(const scene::Solid& solid, std::uint8_t part, const Vec3& point) noexcept;

[[nodiscard]] Crossings cone_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                                       std::uint8_t start_part) noexcept;
[[nodiscard]] Vec3 cone_normal(const scene::Solid& solid, std::uint8_t part, const Vec3& point) noexcept;

/// Of cylinders (radius_a at both ends) and cones: the box of the two end discs. A disc of radius r across the unit
/// axis u reaches r·√(1 − uᵢ²) along coordinate i.
[[nodiscard]] Box capped_bounds(const scene::Solid& solid, double radius_b) noexcept;

[[nodiscard]] Crossings plane_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                                        std::uint8_t start_part) noexcept;

}  // namespace isl::render
