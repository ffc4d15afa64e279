// Random expressions over random solids and blobs.
#pragma once

#include "tests/renderer/csg/csg_scene.h"

#include <utility>
#include <vector>

namespace isl::render::test {

inline Object random_leaf(CsgScene& scene, Random& random) {
  const double choice = random.uniform(0, 10);
  if (choice < 1) {
    std::vector<scene::Component> components(3);
    for (scene::Component& c : components) {
      c.a = random.in_cube(0.5);
      c.radius_a = random.uniform(0.6, 1.2);
      c.strength = random.uniform(0.4, 1.2);
    }
    return scene.blob(components, 0.3);
  }
  if (choice < 2) return scene.solid(plane(random.direction(), random.uniform(-0.5, 0.5)));
  if (choice < 4) return scene.solid(random_solid(random, scene::SolidKind::cylinder));
  if (choice < 5) return scene.solid(random_solid(random, scene::SolidKind::cone));
  if (choice < 6) return scene.solid(random_solid(random, scene::SolidKind::sphere));
  if (choice < 7.5) {
    const WholeSolid whole = random_whole(random, scene::SolidKind::quadric);
    return scene.algebraic(whole.polynomial);
  }
  const scene::SolidKind kinds[] = {scene::SolidKind::box, scene::SolidKind::torus, scene::SolidKind::superellipsoid,
                                    scene::SolidKind::ovus};
  return scene.solid(random_whole(random, kinds[static_cast<int>(random.uniform(0, 4))]).solid);
}

/// A random expression. `unite` occurs only if `with_inner`, which keeps its inner surfaces.
inline Object random_tree(CsgScene& scene, Random& random, int depth, bool with_inner) {
  Object result;
  if (depth == 0 || random.uniform(0, 1) < 0.2) {
    result = random_leaf(scene, random);
  } else {
    std::vector<Object> children;
    const int count = 2 + static_cast<int>(random.uniform(0, 2));
    for (int i = 0; i < count; ++i) children.push_back(random_tree(scene, random, depth - 1, with_inner));
    const Operation operations[] = {Operation::merge, Operation::intersect, Operation::subtract, Operation::unite};
    result = scene.group(operations[static_cast<int>(random.uniform(0, with_inner ? 4 : 3))], children);
  }
  result.parent_from_object = random_transform(random);
  result.inverse = random.uniform(0, 1) < 0.15;
  return result;
}

}  // namespace isl::render::test
