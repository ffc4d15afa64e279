// plane: the half-space p·a ≤ radius_a, a of unit length. A line across its border meets it once; one along it never.
#include "renderer/solids/solid_type.h"

#include <limits>

namespace isl::render {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

Crossings plane_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                          std::uint32_t start_part, const SolidDetails&) noexcept {
  Crossings result;
  const double rise = direction.dot(solid.a);
  result.ends_inside = rise < 0 || (rise == 0 && start_part != kSide && origin.dot(solid.a) < solid.radius_a);
  if (start_part != kSide && rise != 0) result.add((solid.radius_a - origin.dot(solid.a)) / rise, kSide);
  return result;
}

Vec3 plane_normal(const scene::Solid& solid, std::uint32_t, const Vec3&, const SolidDetails&) noexcept {
  return solid.a;
}

Box plane_bounds(const scene::Solid&, const SolidDetails&) noexcept { return {Vec3(-kEndless), Vec3(kEndless)}; }

double plane_support(const scene::Database&, const scene::Solid& solid, const Vec3& direction) {
  // Tolerance for directions that are parallel up to the rounding of rotations.
  constexpr double kParallel = 1e-12;
  const double along = direction.dot(solid.a);
  const bool is_along = along > 0 && reach_across(direction, solid.a) <= kParallel * along;
  return is_along ? along * solid.radius_a : kEndless;
}

bool is_behind_plane(const scene::Database&, const scene::Solid& solid, const Vec3& point) {
  return point.dot(solid.a) <= solid.radius_a;
}

}  // namespace

constinit const SolidType kinds::plane{.crossings = plane_crossings,
                                       .normal = plane_normal,
                                       .bounds = plane_bounds,
                                       .support = plane_support,
                                       .is_inside = is_behind_plane};

}  // namespace isl::render
