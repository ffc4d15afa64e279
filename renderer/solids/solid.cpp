// Dispatch by kind: the only place that lists the solids. A new one is a file, a line in kinds.h and a case in each
// switch.
#include "renderer/solids/solid.h"

#include "base/check.h"
#include "renderer/solids/kinds.h"

#include <limits>

namespace isl::render {

using scene::SolidKind;

Crossings crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction, std::uint8_t start_part,
                    const SolidDetails& details) noexcept {
  switch (solid.kind) {
    case SolidKind::sphere: return sphere_crossings(solid, origin, direction, start_part);
    case SolidKind::cylinder: return cylinder_crossings(solid, origin, direction, start_part);
    case SolidKind::cone: return cone_crossings(solid, origin, direction, start_part);
    case SolidKind::plane: return plane_crossings(solid, origin, direction, start_part);
    case SolidKind::box: return box_crossings(solid, origin, direction, start_part);
    case SolidKind::torus: return torus_crossings(solid, origin, direction, start_part);
    case SolidKind::disc: return disc_crossings(solid, origin, direction, start_part, false);
    case SolidKind::quadric:
    case SolidKind::cubic:
    case SolidKind::quartic:
    case SolidKind::poly: return polynomial_crossings(details.polynomials[solid.detail], origin, direction, start_part);
    case SolidKind::superellipsoid: return superellipsoid_crossings(solid, origin, direction, start_part);
    case SolidKind::triangle:
    case SolidKind::smooth_triangle:
      return triangle_crossings(details.triangles[solid.detail], origin, direction, start_part);
    case SolidKind::polygon: return polygon_crossings(details.polygons[solid.detail], origin, direction, start_part);
  }
  ISL_CHECK(false, "solid kind {}", static_cast<int>(solid.kind));
}

Crossings boundary(const scene::Solid& solid, const Vec3& origin, const Vec3& direction, std::uint8_t start_part,
                   const SolidDetails& details) noexcept {
  if (solid.kind == SolidKind::disc) return disc_crossings(solid, origin, direction, start_part, true);
  if (!solid.open) return crossings(solid, origin, direction, start_part, details);
  scene::Solid closed = solid;
  closed.open = false;
  Crossings result = crossings(closed, origin, direction, start_part, details);
  for (std::size_t i = 0; i < static_cast<std::size_t>(result.count); ++i) {
    if (result.part[i] != kSide) result.part[i] = kUnseen;
  }
  return result;
}

bool is_sheet(const scene::Solid& solid) noexcept {
  return scene::is_triangle(solid.kind) || solid.kind == SolidKind::polygon ||
         (solid.kind == SolidKind::box && is_flat_box(solid));
}

Vec3 normal_at(const scene::Solid& solid, std::uint8_t part, const Vec3& point, const SolidDetails& details) noexcept {
  switch (solid.kind) {
    case SolidKind::sphere: return sphere_normal(solid, point);
    case SolidKind::cylinder: return cylinder_normal(solid, part, point);
    case SolidKind::cone: return cone_normal(solid, part, point);
    case SolidKind::plane: return solid.a;
    case SolidKind::box: return box_normal(part);
    case SolidKind::torus: return torus_normal(solid, point);
    case SolidKind::disc: return solid.b;
    case SolidKind::quadric:
    case SolidKind::cubic:
    case SolidKind::quartic:
    case SolidKind::poly: return polynomial_normal(details.polynomials[solid.detail], point);
    case SolidKind::superellipsoid: return superellipsoid_normal(solid, point);
    case SolidKind::triangle:
    case SolidKind::smooth_triangle: return triangle_normal(details.triangles[solid.detail]);
    case SolidKind::polygon: return details.polygons[solid.detail].normal;
  }
  ISL_CHECK(false, "solid kind {}", static_cast<int>(solid.kind));
}

Vec3 shading_normal_at(const scene::Solid& solid, std::uint8_t part, const Vec3& point,
                       const SolidDetails& details) noexcept {
  if (solid.kind == SolidKind::smooth_triangle) return smooth_normal(details.triangles[solid.detail], point);
  return normal_at(solid, part, point, details);
}

Box bounds(const scene::Solid& solid, const SolidDetails& details) noexcept {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  switch (solid.kind) {
    case SolidKind::sphere: return sphere_bounds(solid);
    case SolidKind::cylinder: return capped_bounds(solid, solid.radius_a);
    case SolidKind::cone: return capped_bounds(solid, solid.radius_b);
    case SolidKind::plane: return {Vec3(-kFar), Vec3(kFar)};
    case SolidKind::box: return {solid.a, solid.b};
    case SolidKind::torus: return torus_bounds(solid);
    case SolidKind::disc: return disc_bounds(solid);
    case SolidKind::quadric:
    case SolidKind::cubic:
    case SolidKind::quartic:
    case SolidKind::poly: return polynomial_bounds(details.polynomials[solid.detail]);
    case SolidKind::superellipsoid: return {Vec3(-1), Vec3(1)};
    case SolidKind::triangle:
    case SolidKind::smooth_triangle: return triangle_bounds(details.triangles[solid.detail]);
    case SolidKind::polygon: return details.polygons[solid.detail].box;
  }
  ISL_CHECK(false, "solid kind {}", static_cast<int>(solid.kind));
}

}  // namespace isl::render
