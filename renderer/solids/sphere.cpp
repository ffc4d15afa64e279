// sphere: |p − a| = radius_a. The quadratic and its care are in quadratic.h.
#include "renderer/solids/quadratic.h"
#include "renderer/solids/solid_type.h"

namespace isl::render {
namespace {

Crossings sphere_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                           std::uint32_t start_part, const SolidDetails&) noexcept {
  return closed_crossings(within_radius(origin - solid.a, direction, std::abs(solid.radius_a), start_part == kSide));
}

Vec3 sphere_normal(const scene::Solid& solid, std::uint32_t, const Vec3& point, const SolidDetails&) noexcept {
  return (point - solid.a).normalized();
}

Box sphere_bounds(const scene::Solid& solid, const SolidDetails&) noexcept {
  const Vec3 reach(std::abs(solid.radius_a));
  return {solid.a - reach, solid.a + reach};
}

double sphere_support(const scene::Database&, const scene::Solid& solid, const Vec3& direction) {
  return direction.dot(solid.a) + solid.radius_a * direction.length();
}

bool is_in_sphere(const scene::Database&, const scene::Solid& solid, const Vec3& point) {
  return (point - solid.a).length() < solid.radius_a;
}

Coordinates coordinates_of_sphere(const scene::Solid& solid, const Vec3& point, const Vec3&) noexcept {
  return sphere_coordinates(point - solid.a);
}

}  // namespace

constinit const SolidType kinds::sphere{.crossings = sphere_crossings,
                                        .normal = sphere_normal,
                                        .bounds = sphere_bounds,
                                        .support = sphere_support,
                                        .is_inside = is_in_sphere,
                                        .coordinates = coordinates_of_sphere};

}  // namespace isl::render
