// Exact plain solids: where a line crosses each, its normal and its bounds. One file a solid; this is their common
// face.
#pragma once

#include "renderer/scene/database.h"

#include <ImathBox.h>

#include <array>
#include <cstdint>

namespace isl::render {

using scene::Vec3;
using Box = Imath::Box3d;

/// A start that is on no surface.
inline constexpr std::uint8_t kNoPart = 0xFF;

/// The crossings of a line with a solid's surface, t ascending, over the whole line (negative t too). A closed solid
/// has none or two (for a half-space: one); tangency is no crossing.
struct Crossings {
  int count = 0;
  std::array<double, 2> t{};
  std::array<std::uint8_t, 2> part{};
};

/// `direction` may have any length but zero; t is in units of it. `start_part` names the surface that the origin lies
/// on (kNoPart: none): its root at t = 0 is then known, left out, and deflates the quadric rather than being solved
/// for.
[[nodiscard]] Crossings crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                                  std::uint8_t start_part) noexcept;

/// Outward normal of one of the solid's surfaces at a point on it; unit length. At the apex of a cone: its axis.
[[nodiscard]] Vec3 normal_at(const scene::Solid& solid, std::uint8_t part, const Vec3& point) noexcept;

/// Tight for spheres, cylinders and cones; infinite for a plane.
[[nodiscard]] Box bounds(const scene::Solid& solid) noexcept;

}  // namespace isl::render
