// The common part of cylinders and cones: the cross-sections along the axis from a to b are discs whose radius changes
// linearly from radius_a to radius_b, and the ends are flat unless the solid is open.
#pragma once

#include "renderer/solids/solid_type.h"

namespace isl::render {

/// The flat ends, at Solid::a and at Solid::b; the side is kSide.
inline constexpr std::uint32_t kCapA = 1;
inline constexpr std::uint32_t kCapB = 2;

/// The crossings of the closed solid; those with the missing caps of an open one have the part kUnseen.
[[nodiscard]] inline Crossings capped_boundary(SolidType::CrossingsAlong crossings, const scene::Solid& solid,
                                               const Vec3& origin, const Vec3& direction, std::uint32_t start_part,
                                               const SolidDetails& details) noexcept {
  if (!solid.open) return crossings(solid, origin, direction, start_part, details);
  scene::Solid closed = solid;
  closed.open = false;
  Crossings result = crossings(closed, origin, direction, start_part, details);
  for (std::size_t i = 0; i < static_cast<std::size_t>(result.count); ++i) {
    if (result.part[i] == kCapA || result.part[i] == kCapB) result.part[i] = kUnseen;
  }
  return result;
}

/// The box of the two end discs. A disc of radius r across the unit axis u reaches r·√(1 − uᵢ²) along coordinate i.
[[nodiscard]] Box capped_bounds(const scene::Solid& solid, double radius_b) noexcept;

[[nodiscard]] double capped_support(const scene::Solid& solid, double radius_b, const Vec3& direction);

[[nodiscard]] bool is_in_capped(const scene::Solid& solid, double radius_b, const Vec3& point);

}  // namespace isl::render
