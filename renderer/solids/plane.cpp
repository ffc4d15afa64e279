// plane: the half-space p·a ≤ radius_a, a of unit length. A line across its border meets it once; one along it never.
#include "renderer/solids/kinds.h"

namespace isl::render {

Crossings plane_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                          std::uint8_t start_part) noexcept {
  Crossings result;
  const double rise = direction.dot(solid.a);
  result.ends_inside = rise < 0 || (rise == 0 && start_part != kSide && origin.dot(solid.a) < solid.radius_a);
  if (start_part != kSide && rise != 0) result.add((solid.radius_a - origin.dot(solid.a)) / rise, kSide);
  return result;
}

}  // namespace isl::render
