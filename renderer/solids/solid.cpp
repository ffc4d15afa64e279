// Calls the functions of the kinds (solid_type.h) by a table in the order of SolidKind.
#include "renderer/solids/solid.h"

#include "renderer/solids/solid_type.h"

#include <algorithm>
#include <cmath>

namespace isl::render {
namespace {

constexpr const SolidType* kTypes[] = {
#define ISL_SOLID(word, ...) &kinds::word,
#include "renderer/scene/solids.def"
};

const SolidType& type_of(const scene::Solid& solid) { return *kTypes[static_cast<std::size_t>(solid.kind)]; }

}  // namespace

Crossings crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction, std::uint32_t start_part,
                    const SolidDetails& details) noexcept {
  return type_of(solid).crossings(solid, origin, direction, start_part, details);
}

Crossings crossings_to_first(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                             std::uint32_t start_part, const SolidDetails& details) noexcept {
  return type_of(solid).crossings_to_first(solid, origin, direction, start_part, details);
}

Crossings boundary(const scene::Solid& solid, const Vec3& origin, const Vec3& direction, std::uint32_t start_part,
                   const SolidDetails& details, const Stretch& stretch) noexcept {
  const SolidType& type = type_of(solid);
  if (type.boundary_in_stretch) {
    return type.boundary_in_stretch(solid, origin, direction, start_part, details, stretch);
  }
  return type.boundary(solid, origin, direction, start_part, details);
}

bool gains_by_stretch(const scene::Solid& solid) noexcept { return type_of(solid).boundary_in_stretch != nullptr; }

bool is_open_surface(const scene::Solid& solid) noexcept { return type_of(solid).is_open_surface(solid); }

bool is_part_of_plane(const scene::Solid& solid) noexcept { return type_of(solid).is_part_of_plane; }

Vec3 normal_at(const scene::Solid& solid, std::uint32_t part, const Vec3& point, const SolidDetails& details) noexcept {
  return type_of(solid).normal(solid, part, point, details);
}

Vec3 shading_normal_at(const scene::Solid& solid, std::uint32_t part, const Vec3& point,
                       const SolidDetails& details) noexcept {
  return type_of(solid).shading_normal(solid, part, point, details);
}

Coordinates solid_coordinates(const scene::Solid& solid, const Vec3& point, const Vec3& world) noexcept {
  return type_of(solid).coordinates(solid, point, world);
}

Box bounds(const scene::Solid& solid, const SolidDetails& details) noexcept {
  return type_of(solid).bounds(solid, details);
}

double terms_over_gradient(const scene::Solid& solid, const Vec3& point, const SolidDetails& details) noexcept {
  return type_of(solid).terms_over_gradient(solid, point, details);
}

double support(const scene::Database& database, const scene::Solid& solid, const Vec3& direction) {
  return type_of(solid).support(database, solid, direction);
}

Box box_of(const scene::Database& database, const scene::Solid& solid, const scene::Transform& world_from_solid) {
  const scene::Matrix& m = world_from_solid.matrix;
  Box result;
  for (int i = 0; i < 3; ++i) {
    // The coordinate i of a mapped point p is this · p, plus the offset.
    const Vec3 direction(m[0][i], m[1][i], m[2][i]);
    result.max[i] = support(database, solid, direction) + m[3][i];
    result.min[i] = -support(database, solid, -direction) + m[3][i];
  }
  return result;
}

bool is_inside(const scene::Database& database, const scene::Solid& solid, const Vec3& point) {
  return type_of(solid).is_inside(database, solid, point);
}

double size_of(const scene::Database& database, const scene::Solid& solid) {
  return type_of(solid).size(database, solid);
}

double SolidType::size_of_members(const scene::Database&, const scene::Solid& solid) {
  return std::max({largest(solid.a), largest(solid.b), std::abs(solid.radius_a), std::abs(solid.radius_b)});
}

}  // namespace isl::render
