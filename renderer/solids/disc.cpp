// disc: the ring between radius_b and radius_a about a, in the plane across b. Its inside, which combinations of solids
// ask for, is the half-space behind it, as in POV-Ray: beyond the rim the line passes between both without a surface.
#include "renderer/solids/kinds.h"

#include <cmath>

namespace isl::render {

Crossings disc_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction, std::uint8_t start_part,
                         bool with_unseen) noexcept {
  Crossings result;
  const double rise = direction.dot(solid.b);
  const double below = (solid.a - origin).dot(solid.b);
  result.ends_inside = rise < 0 || (rise == 0 && start_part != kSide && below > 0);
  if (start_part == kSide || rise == 0) return result;
  const double t = below / rise;
  const double distance = (origin + direction * t - solid.a).length();
  const bool is_seen = distance >= solid.radius_b && distance <= solid.radius_a;
  if (is_seen || with_unseen) result.add(t, is_seen ? kSide : kUnseen);
  return result;
}

/// As far as a disc reaches across a unit vector u: r·√(1 − uᵢ²) along coordinate i.
Box disc_bounds(const scene::Solid& solid) noexcept {
  const Vec3 square = solid.b * solid.b;
  const Vec3 reach =
      Vec3(std::sqrt(square.y + square.z), std::sqrt(square.z + square.x), std::sqrt(square.x + square.y)) *
      solid.radius_a;
  return {solid.a - reach, solid.a + reach};
}

}  // namespace isl::render
