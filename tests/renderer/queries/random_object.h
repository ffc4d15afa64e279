// Random objects to ask questions about: a solid of each kind, and places for them.
#pragma once

#include "tests/renderer/csg/random_tree.h"
#include "tests/renderer/solids/random_outline.h"

#include <cmath>

namespace isl::render::test {

/// A uniform scale of 10⁻⁶ to 10⁶, with a slight stretch, a rotation, and a shift of up to 1000 times the size.
struct Place {
  double scale;
  scene::Transform transform;

  explicit Place(Random& random) : scale(std::pow(10, random.uniform(-6, 6))) {
    scene::Matrix shift;
    shift.setTranslation(random.direction() * scale * std::pow(10, random.uniform(-1, 3)));
    scene::Matrix size;
    size.setScale(Vec3(scale));
    transform = then(then(random_transform(random), affine(size)), affine(shift));
  }
};

inline Object random_of_kind(CsgScene& scene, Random& random, scene::SolidKind kind) {
  switch (kind) {
    case scene::SolidKind::sphere:
    case scene::SolidKind::cylinder:
    case scene::SolidKind::cone:
    case scene::SolidKind::plane: return scene.solid(random_solid(random, kind));
    case scene::SolidKind::disc: {
      scene::Solid disc = random_solid(random, scene::SolidKind::sphere);
      disc.kind = kind;
      disc.b = random.direction();
      disc.radius_b = disc.radius_a * random.uniform(0, 0.5);
      return scene.solid(disc);
    }
    case scene::SolidKind::triangle:
    case scene::SolidKind::smooth_triangle: {
      scene::Triangle triangle;
      for (int i = 0; i < 3; ++i) triangle.corners[i] = random.in_cube(1), triangle.normals[i] = random.direction();
      scene.database.triangles.push_back(triangle);
      scene::Solid solid;
      solid.kind = kind;
      solid.detail = static_cast<std::uint32_t>(scene.database.triangles.size() - 1);
      return scene.solid(solid);
    }
    case scene::SolidKind::polygon: {
      const Vec3 a = random.in_cube(1), u = random.direction(), v = random.direction();
      scene.database.polygons.push_back({{a, a + u, a + u + v, a + v, a}});
      scene::Solid solid;
      solid.kind = kind;
      solid.detail = static_cast<std::uint32_t>(scene.database.polygons.size() - 1);
      return scene.solid(solid);
    }
    case scene::SolidKind::prism:
    case scene::SolidKind::text: {
      scene.database.outlines.push_back(random_outline(random));
      scene::Solid solid{.kind = kind, .radius_a = random.uniform(-1, 0), .radius_b = random.uniform(0.1, 1)};
      solid.detail = static_cast<std::uint32_t>(scene.database.outlines.size() - 1);
      return scene.solid(solid);
    }
    default: break;
  }
  const WholeSolid whole = random_whole(random, kind);
  return scene::is_polynomial(kind) ? scene.algebraic(whole.polynomial) : scene.solid(whole.solid);
}

}  // namespace isl::render::test
