// cylinder: points within radius_a of the axis a b, between the planes through a and b across it.
//
// Perpendicular to the axis, the components of origin and direction meet a circle (quadratic.h); along the axis, the
// line meets a slab. A ray along the axis has no perpendicular component: it is within the circle everywhere or
// nowhere.
#include "renderer/solids/line_interval.h"
#include "renderer/solids/quadratic.h"

namespace isl::render {
namespace {

Crossings cylinder_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                             std::uint32_t start_part, const SolidDetails&) noexcept {
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

Vec3 cylinder_normal(const scene::Solid& solid, std::uint32_t part, const Vec3& point, const SolidDetails&) noexcept {
  const Axis axis(solid);
  if (part == kCapA) return -axis.along;
  if (part == kCapB) return axis.along;
  return axis.across(point - solid.a).normalized();
}

Crossings cylinder_boundary(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                            std::uint32_t start_part, const SolidDetails& details) noexcept {
  return capped_boundary(cylinder_crossings, solid, origin, direction, start_part, details);
}

Box cylinder_bounds(const scene::Solid& solid, const SolidDetails&) noexcept {
  return capped_bounds(solid, solid.radius_a);
}

double cylinder_support(const scene::Database&, const scene::Solid& solid, const Vec3& direction) {
  return capped_support(solid, solid.radius_a, direction);
}

bool is_in_cylinder(const scene::Database&, const scene::Solid& solid, const Vec3& point) {
  return is_in_capped(solid, solid.radius_a, point);
}

}  // namespace

constinit const SolidType kinds::cylinder{.crossings = cylinder_crossings,
                                          .boundary = cylinder_boundary,
                                          .normal = cylinder_normal,
                                          .bounds = cylinder_bounds,
                                          .support = cylinder_support,
                                          .is_inside = is_in_cylinder};

}  // namespace isl::render
