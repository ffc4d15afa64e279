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

[[nodiscard]] Crossings box_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                                      std::uint8_t start_part) noexcept;
[[nodiscard]] Vec3 box_normal(std::uint8_t part) noexcept;
[[nodiscard]] bool is_flat_box(const scene::Solid& solid) noexcept;

[[nodiscard]] Crossings torus_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                                        std::uint8_t start_part) noexcept;
[[nodiscard]] Vec3 torus_normal(const scene::Solid& solid, const Vec3& point) noexcept;
[[nodiscard]] Box torus_bounds(const scene::Solid& solid) noexcept;

/// `with_unseen`: beyond the rim too.
[[nodiscard]] Crossings disc_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                                       std::uint8_t start_part, bool with_unseen) noexcept;
[[nodiscard]] Box disc_bounds(const scene::Solid& solid) noexcept;

[[nodiscard]] Crossings superellipsoid_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                                                 std::uint8_t start_part) noexcept;
[[nodiscard]] Vec3 superellipsoid_normal(const scene::Solid& solid, const Vec3& point) noexcept;

[[nodiscard]] Crossings polynomial_crossings(const PreparedPolynomial& polynomial, const Vec3& origin,
                                             const Vec3& direction, std::uint8_t start_part) noexcept;
[[nodiscard]] Vec3 polynomial_normal(const PreparedPolynomial& polynomial, const Vec3& point) noexcept;
[[nodiscard]] Box polynomial_bounds(const PreparedPolynomial& polynomial) noexcept;

[[nodiscard]] Crossings triangle_crossings(const scene::Triangle& triangle, const Vec3& origin, const Vec3& direction,
                                           std::uint8_t start_part) noexcept;
[[nodiscard]] Vec3 triangle_normal(const scene::Triangle& triangle) noexcept;
[[nodiscard]] Vec3 smooth_normal(const scene::Triangle& triangle, const Vec3& point) noexcept;
[[nodiscard]] Box triangle_bounds(const scene::Triangle& triangle) noexcept;

[[nodiscard]] Crossings polygon_crossings(const PreparedPolygon& polygon, const Vec3& origin, const Vec3& direction,
                                          std::uint8_t start_part) noexcept;

}  // namespace isl::render
