// Random expressions over random solids and blobs against the definition of their insides: along random lines, inside
// and outside alternate at the hits and nowhere else.
#include "tests/renderer/csg/csg_scene.h"

#include <gtest/gtest.h>

namespace isl::render::test {
namespace {

using scene::SolidKind;

Object random_leaf(CsgScene& scene, Random& random) {
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
  if (choice < 4) return scene.solid(random_solid(random, SolidKind::cylinder));
  if (choice < 5) return scene.solid(random_solid(random, SolidKind::cone));
  if (choice < 6) return scene.solid(random_solid(random, SolidKind::sphere));
  if (choice < 7.5) {
    const WholeSolid whole = random_whole(random, SolidKind::quadric);
    return scene.algebraic(whole.polynomial);
  }
  const SolidKind kinds[] = {SolidKind::box, SolidKind::torus, SolidKind::superellipsoid};
  return scene.solid(random_whole(random, kinds[static_cast<int>(random.uniform(0, 3))]).solid);
}

/// `unite` only with `with_inner`: its inner surfaces change nothing.
Object random_tree(CsgScene& scene, Random& random, int depth, bool with_inner) {
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

void check_line(const CsgScene& scene, const Tracer& tracer, const Vec3& origin, const Vec3& direction, Random& random,
                int& hits) {
  const Walk found = walk(tracer, origin, direction);
  ASSERT_LT(found.t.size(), 200u);
  const bool starts_inside = scene.inside(origin);
  for (std::size_t i = 0; i < found.t.size(); ++i) {
    ASSERT_EQ(found.hits[i].from_inside, starts_inside != (i % 2 == 1)) << "hit " << i << " at " << found.t[i];
  }
  hits += static_cast<int>(found.t.size());
  for (int i = 0; i < 24; ++i) {
    const double t = random.uniform(0, 8);
    bool expected = starts_inside, is_near = false;
    for (const double crossing : found.t) {
      expected ^= crossing < t;
      is_near |= std::abs(crossing - t) < 1e-7;
    }
    if (is_near) continue;
    ASSERT_EQ(scene.inside(origin + direction * t), expected)
        << "at " << t << " from " << origin << " along " << direction;
  }
}

TEST(RandomTrees, alternate_at_their_hits) {
  Random random(61);
  int hits = 0;
  for (int turn = 0; turn < 600; ++turn) {
    CsgScene scene;
    Object root = random_tree(scene, random, 4, false);
    if (root.kind != Object::Kind::group) continue;
    scene.database.objects = {root};
    TracerOptions options;
    options.solver = SolverName::exact;
    const Tracer tracer(scene.database, options);
    for (int line = 0; line < 40; ++line) {
      const Vec3 direction = random.direction();
      const Vec3 origin = random.in_cube(1) - direction * (random.uniform(0, 1) < 0.7 ? 4 : 0);
      check_line(scene, tracer, origin, direction, random, hits);
      if (testing::Test::HasFatalFailure()) FAIL() << "tree " << turn << " line " << line;
    }
  }
  EXPECT_GT(hits, 3000);
}

TEST(RandomTrees, of_unions_show_no_surface_where_nothing_is) {
  Random random(62);
  for (int turn = 0; turn < 100; ++turn) {
    CsgScene scene;
    const Object root = random_tree(scene, random, 3, true);
    scene.database.objects = {root};
    TracerOptions options;
    options.solver = SolverName::exact;
    const Tracer tracer(scene.database, options);
    for (int line = 0; line < 40; ++line) {
      const Vec3 direction = random.direction(), origin = random.in_cube(1) - direction * 4;
      const Walk found = walk(tracer, origin, direction);
      ASSERT_LT(found.t.size(), 200u);
      for (std::size_t i = 0; i < found.t.size(); ++i) {
        const Vec3 before = origin + direction * (found.t[i] - 1e-6), after = origin + direction * (found.t[i] + 1e-6);
        bool is_lone = true;
        for (std::size_t k = 0; k < found.t.size(); ++k) is_lone &= k == i || std::abs(found.t[k] - found.t[i]) > 1e-5;
        if (!is_lone) continue;
        EXPECT_TRUE(scene.inside(before) || scene.inside(after));
      }
    }
  }
}

}  // namespace
}  // namespace isl::render::test
