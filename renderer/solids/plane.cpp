// plane: the half-space p·a ≤ radius_a, a of unit length. A line across its border meets it once; one along it never.
#include "renderer/solids/kinds.h"

namespace isl::render {

Crossings plane_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                          std::uint8_t start_part) noexcept {
  Crossings result;
  const double rise = direction.dot(solid.a);
  if (start_part == kSide || rise == 0) return result;
  result.t[0] = (solid.radius_a - origin.dot(solid.a)) / rise;
  result.part[0] = kSide;
  result.count = 1;
  return result;
}

}  // namespace isl::render
