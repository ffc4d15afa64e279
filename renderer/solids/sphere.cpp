// sphere: |p − a| = radius_a. The quadratic and its care are in quadratic.h.
#include "renderer/solids/quadratic.h"

namespace isl::render {

Crossings sphere_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                           std::uint8_t start_part) noexcept {
  return closed_crossings(within_radius(origin - solid.a, direction, std::abs(solid.radius_a), start_part == kSide));
}

Vec3 sphere_normal(const scene::Solid& solid, const Vec3& point) noexcept { return (point - solid.a).normalized(); }

Box sphere_bounds(const scene::Solid& solid) noexcept {
  const Vec3 reach(std::abs(solid.radius_a));
  return {solid.a - reach, solid.a + reach};
}

}  // namespace isl::render
