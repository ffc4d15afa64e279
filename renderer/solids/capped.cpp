#include "renderer/solids/capped.h"

#include "renderer/solids/line_interval.h"

namespace isl::render {

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

double capped_support(const scene::Solid& solid, double radius_b, const Vec3& direction) {
  const double reach = reach_across(direction, (solid.b - solid.a).normalized());
  return std::max(direction.dot(solid.a) + solid.radius_a * reach, direction.dot(solid.b) + radius_b * reach);
}

bool is_in_capped(const scene::Solid& solid, double radius_b, const Vec3& point) {
  const Vec3 axis = solid.b - solid.a, from_a = point - solid.a;
  const double along = from_a.dot(axis) / axis.dot(axis);
  if (!(along > 0 && along < 1)) return false;
  const double radius = solid.radius_a + (radius_b - solid.radius_a) * along;
  return (from_a - axis * along).length() < radius;
}

}  // namespace isl::render
