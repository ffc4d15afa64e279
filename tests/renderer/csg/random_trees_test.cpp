// Random expressions over random solids and blobs, compared with the definition of their insides: along random lines,
// inside and outside alternate at the hits and nowhere else.
#include "tests/renderer/csg/random_tree.h"

#include <gtest/gtest.h>

namespace isl::render::test {
namespace {

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

TEST(RandomTrees, end_for_the_published_solvers_too) {
  // A ray continues from a blob's surface into the blob. Its hits are not exact, and a walk can stand still where one
  // ray's interpolants disagree with the next one's; but every search ends.
  Random random(63);
  std::size_t hits = 0;
  for (int turn = 0; turn < 100; ++turn) {
    CsgScene scene;
    const Object root = random_tree(scene, random, 3, false);
    scene.database.objects = {root};
    TracerOptions options;
    options.solver = turn % 2 == 0 ? SolverName::paper : SolverName::iso;
    options.interpolants = 2;
    const Tracer tracer(scene.database, options);
    for (int line = 0; line < 40; ++line) {
      const Vec3 direction = random.direction(), origin = random.in_cube(1) - direction * 4;
      hits += walk(tracer, origin, direction, 20).t.size();
    }
  }
  EXPECT_GT(hits, 1000u);
}

TEST(RandomTrees, show_through_many_interpolants_what_is_there) {
  // Two blobs of points, one subtracted from the other, with sixteen interpolants a field: nearly every line agrees.
  Random random(64);
  CsgScene scene;
  const auto ball = [](const Vec3& at, double radius) {
    scene::Component component;
    component.a = at;
    component.radius_a = radius;
    return component;
  };
  const Object whole = scene.blob({ball({0, 0, 0}, 1.2), ball({0.9, 0.2, 0}, 1)}, 0.3);
  const Object taken = scene.blob({ball({0, 0, -0.8}, 0.9), ball({0.5, 0.5, -0.6}, 0.7)}, 0.3);
  scene.database.objects = {scene.group(scene::Operation::subtract, {whole, taken})};
  TracerOptions options;
  options.solver = SolverName::paper;
  options.interpolants = 16;
  const Tracer published(scene.database, options);
  options.solver = SolverName::exact;
  const Tracer exact(scene.database, options);
  int lines = 0, agree = 0;
  for (int line = 0; line < 2000; ++line) {
    const Vec3 direction = random.direction(), origin = random.in_cube(0.7) - direction * 4;
    const Walk a = walk(published, origin, direction), b = walk(exact, origin, direction);
    if (b.t.empty()) continue;
    ++lines;
    bool same = a.t.size() == b.t.size();
    for (std::size_t i = 0; same && i < a.t.size(); ++i) same = std::abs(a.t[i] - b.t[i]) < 1e-3;
    agree += same ? 1 : 0;
  }
  EXPECT_GT(lines, 500);
  EXPECT_GT(agree, lines * 97 / 100) << agree << " of " << lines;
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
