// (u, v) of plain solids.
#pragma once

#include "renderer/scene/solids.h"
#include "renderer/solids/surface_coordinates.h"

namespace isl::render {

/// At a point on the surface, in the solid's space and in the world. POV-Ray knows coordinates of the sphere, the torus
/// and the box; of every other solid they are (x, y) in the world.
[[nodiscard]] inline Coordinates solid_coordinates(const scene::Solid& solid, const Vec3& point, const Vec3& world) {
  switch (solid.kind) {
    case scene::SolidKind::sphere: return sphere_coordinates(point - solid.a);
    case scene::SolidKind::torus: return torus_coordinates(point, solid.radius_a);
    case scene::SolidKind::box: return box_coordinates(solid.a, solid.b, point);
    default: return {world.x, world.y};
  }
}

}  // namespace isl::render
