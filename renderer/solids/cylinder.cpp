// cylinder: points within radius_a of the axis a b, between the planes through a and b across it.
//
// Across the axis the problem is a circle's (quadratic.h) for the shares of origin and direction across it; along the
// axis it is a slab. A ray along the axis has no share across: then it is within the circle everywhere or nowhere.
#include "renderer/solids/quadratic.h"

namespace isl::render {

Crossings cylinder_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                             std::uint8_t start_part) noexcept {
  const Axis axis(solid);
  if (!axis.valid) return {};
  LineInterval side = within_radius(axis.across(origin - solid.a), axis.across(direction), std::abs(solid.radius_a),
                                    start_part == kSide);
  const LineInterval slab = slab_interval(solid, axis, origin, direction, start_part);
  if (solid.open) return open_crossings(side, slab);
  if (side.empty()) return {};
  if (start_part == kCapA || start_part == kCapB) side.hold_origin();
  return closed_crossings(intersection(side, slab));
}

Vec3 cylinder_normal(const scene::Solid& solid, std::uint8_t part, const Vec3& point) noexcept {
  const Axis axis(solid);
  if (part == kCapA) return -axis.along;
  if (part == kCapB) return axis.along;
  return axis.across(point - solid.a).normalized();
}

Box capped_bounds(const scene::Solid& solid, double radius_b) noexcept {
  const Axis axis(solid);
  const Vec3 square = axis.along * axis.along;
  const Vec3 reach(std::sqrt(square.y + square.z), std::sqrt(square.z + square.x), std::sqrt(square.x + square.y));
  const Vec3 reach_a = reach * std::abs(solid.radius_a);
  const Vec3 reach_b = reach * std::abs(radius_b);
  Box box(solid.a - reach_a, solid.a + reach_a);
  box.extendBy(Box(solid.b - reach_b, solid.b + reach_b));
  return box;
}

}  // namespace isl::render
