// disc: the ring between radius_b and radius_a about a, in the plane across b. Its inside, which combinations of solids
// ask for, is the half-space behind it, as in POV-Ray: beyond the rim the line passes between both without a surface.
#include "renderer/solids/solid_type.h"

namespace isl::render {
namespace {

/// `with_unseen`: crossings of the plane beyond the rim are included, with the part kUnseen.
template <bool with_unseen>
Crossings disc_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction, std::uint32_t start_part,
                         const SolidDetails&) noexcept {
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

Vec3 disc_normal(const scene::Solid& solid, std::uint32_t, const Vec3&, const SolidDetails&) noexcept {
  return solid.b;
}

/// A disc of radius r with the unit normal u extends r·√(1 − uᵢ²) along coordinate i.
Box disc_bounds(const scene::Solid& solid, const SolidDetails&) noexcept {
  const Vec3 square = solid.b * solid.b;
  const Vec3 reach =
      Vec3(std::sqrt(square.y + square.z), std::sqrt(square.z + square.x), std::sqrt(square.x + square.y)) *
      solid.radius_a;
  return {solid.a - reach, solid.a + reach};
}

double disc_support(const scene::Database&, const scene::Solid& solid, const Vec3& direction) {
  return direction.dot(solid.a) + solid.radius_a * reach_across(direction, solid.b);
}

bool is_behind_disc(const scene::Database&, const scene::Solid& solid, const Vec3& point) {
  return (point - solid.a).dot(solid.b) < 0;
}

}  // namespace

constinit const SolidType kinds::disc{.crossings = disc_crossings<false>,
                                      .boundary = disc_crossings<true>,
                                      .normal = disc_normal,
                                      .bounds = disc_bounds,
                                      .support = disc_support,
                                      .is_inside = is_behind_disc,
                                      .is_part_of_plane = true};

}  // namespace isl::render
