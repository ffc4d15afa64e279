// `trace` walks through objects of every kind, with each step starting on the point that the last one returned: it must
// find every crossing of the line exactly once. The line's crossings are known independently: for blobs from the
// reference, which proves where their roots are; for all other objects from rays that are told the surface they start
// on and need not find out.
#include "renderer/queries/object_queries.h"
#include "renderer/reference/reference_tracer.h"
#include "tests/reference/random_scenes.h"
#include "tests/renderer/queries/random_object.h"

#include <gtest/gtest.h>

#include <cmath>

namespace isl::render::test {
namespace {

using scene::SolidKind;

/// A crossing of a line: its t and |n·d| there.
struct Crossed {
  double t, slope;
};

std::vector<Crossed> walked(const CsgScene& scene, const Vec3& origin, const Vec3& direction) {
  ObjectQueries queries;
  std::vector<Crossed> found;
  Vec3 from = origin;
  while (found.size() < 300) {
    const auto next = queries.trace(scene.database, scene.database.objects[0], from, direction).point;
    if (!next) return found;
    found.push_back({(next->position - origin).dot(direction), std::abs(next->normal.dot(direction))});
    from = next->position;
  }
  ADD_FAILURE() << "the walk does not end";
  return found;
}

std::vector<Crossed> known(const CsgScene& scene, const Vec3& origin, const Vec3& direction) {
  std::vector<Crossed> result;
  if (scene.database.objects[0].kind == Object::Kind::blob) {
    const reference::ReferenceScene reference(scene.database);
    const auto& placed = reference.placed()[0];
    const auto roots =
        reference::roots_along(placed.field, reference::ReferenceScene::field_ray(placed, origin, direction), {});
    for (const auto& crossing : roots.crossings) result.push_back({static_cast<double>(crossing.t), 0});
    return result;
  }
  TracerOptions options;
  options.solver = SolverName::exact;
  const Tracer tracer(scene.database, options);
  for (const double t : walk(tracer, origin, direction).t) result.push_back({t, 0});
  return result;
}

/// The distance within which `trace` does not tell surfaces apart, with room for a stretched object.
double least_of(const Place& place, const Vec3& origin) {
  const auto& m = place.transform.matrix;
  const Vec3 at(m[3][0], m[3][1], m[3][2]);
  return 0x1p-39 * (at.length() + 4 * place.scale) + 0x1p-50 * origin.length();
}

/// Expects exactly the known crossings, except for neighbours that are no farther apart than the least distance: of
/// those both may be missing.
void expect_same(const std::vector<Crossed>& found, const std::vector<Crossed>& known, double least, double scale) {
  // The length for which a grazing ray stays within the least distance of a surface of this curvature.
  const double graze = 4 * std::sqrt(least * scale);
  std::size_t i = 0, k = 0;
  while (i < found.size() || k < known.size()) {
    const bool both = i < found.size() && k < known.size();
    if (both && std::abs(found[i].t - known[k].t) <= least / std::max(found[i].slope, std::sqrt(least / scale))) {
      ++i, ++k;
    } else if (k + 1 < known.size() && known[k + 1].t - known[k].t <= graze) {
      k += 2;
    } else if (i + 1 < found.size() && found[i + 1].t - found[i].t <= graze) {
      i += 2;
    } else {
      std::string lists;
      for (const Crossed& c : found) lists += " " + std::to_string(c.t / scale);
      lists += " |";
      for (const Crossed& c : known) lists += " " + std::to_string(c.t / scale);
      FAIL() << "found | known, in sizes:" << lists;
    }
  }
}

void check_object(CsgScene& scene, Random& random, Object object, int lines, int& crossings) {
  const Place place(random);
  object.parent_from_object = then(object.parent_from_object, place.transform);
  scene.database.objects = {object};
  for (int line = 0; line < lines; ++line) {
    const Vec3 direction = random.direction();
    const Vec3 aim = place.transform.point(random.in_cube(0.8));
    const Vec3 origin = aim - direction * (place.scale * std::pow(10, random.uniform(0.7, 3)));
    // A polynomial may cross the line again 10⁹ sizes away, where its roots are less well known from here.
    const auto is_far = [&](const Crossed& c) { return c.t > 2000 * place.scale; };
    std::vector<Crossed> found = walked(scene, origin, direction), expected = known(scene, origin, direction);
    std::erase_if(found, is_far);
    std::erase_if(expected, is_far);
    expect_same(found, expected, least_of(place, origin), place.scale);
    if (testing::Test::HasFatalFailure()) FAIL() << "line " << line << " from " << origin << " along " << direction;
    crossings += static_cast<int>(found.size());
  }
}

TEST(WalkByTrace, finds_every_crossing_of_a_solid_once) {
  Random random(501);
  for (int kind = 0; kind < scene::kSolidKindCount; ++kind) {
    int crossings = 0;
    for (int turn = 0; turn < 12; ++turn) {
      CsgScene scene;
      const Object object = random_of_kind(scene, random, static_cast<SolidKind>(kind));
      check_object(scene, random, object, 40, crossings);
      if (HasFatalFailure()) FAIL() << "kind " << kind << " turn " << turn;
    }
    EXPECT_GT(crossings, 20) << "kind " << kind;
  }
}

TEST(WalkByTrace, finds_every_crossing_of_a_blob_once) {
  reference::RandomSource source(502);
  Random random(502);
  int crossings = 0;
  for (int turn = 0; turn < 40; ++turn) {
    CsgScene scene;
    scene.database = reference::random_blob(
        source, {.components = 8, .maxima = turn % 4 == 1, .half_space = turn % 4 == 2, .convolutions = turn % 4 == 3});
    check_object(scene, random, scene.database.objects[0], 12, crossings);
    if (HasFatalFailure()) FAIL() << "turn " << turn;
  }
  EXPECT_GT(crossings, 300);
}

TEST(WalkByTrace, finds_every_crossing_of_a_combination_or_union_once) {
  Random random(503);
  int crossings = 0;
  for (int turn = 0; turn < 200; ++turn) {
    CsgScene scene;
    const Object root = random_tree(scene, random, 3, true);
    check_object(scene, random, root, 15, crossings);
    if (HasFatalFailure()) FAIL() << "turn " << turn;
  }
  EXPECT_GT(crossings, 2000);
}

TEST(WalkByTrace, finds_an_even_number_however_little_a_line_dips_below_the_surface) {
  Random random(505);
  int dips[2] = {0, 0};
  for (int form = 0; form < 3; ++form) {
    CsgScene scene;
    const Vec3 centre(0.3, -0.2, 0.5);
    scene::Component component;
    component.a = centre;
    component.radius_a = 2;
    component.strength = 1;
    // A ball of radius 1: POV-Ray's component of radius 2 has (1 − 1/4)² there.
    scene.database.objects = {form == 0   ? scene.solid(sphere(centre, 1))
                              : form == 1 ? scene.blob({component}, 0.5625)
                                          : scene.solid(box(centre - Vec3(1), centre + Vec3(1)))};
    for (int line = 0; line < 4000; ++line) {
      // The line runs along the surface towards a point at this depth below a pole, or below an edge or face of the
      // box.
      const double depth = std::pow(10, random.uniform(-17, -9));
      Vec3 up = random.direction(), along = random.direction();
      if (form == 2) {
        up = line % 2 == 0 ? Vec3(1, 1, 0) : Vec3(1, 0, 0);
        if (line % 2 == 0) along = Vec3(1, -1, random.uniform(-1, 1));
      }
      along = (along - up * (along.dot(up) / up.dot(up))).normalized();
      if (form == 2 && line % 2 == 1) along = (along - up * std::pow(10, random.uniform(-9, 0))).normalized();
      const Vec3 aim = centre + up * (1 - depth);
      const std::size_t found = walked(scene, aim - along * 3, along).size();
      ASSERT_EQ(found % 2, 0u) << "form " << form << " line " << line << " depth " << depth;
      ++dips[found == 0 ? 0 : 1];
    }
  }
  EXPECT_GT(dips[0], 1000);
  EXPECT_GT(dips[1], 1000);
}

TEST(WalkByTrace, reaches_the_surface_whatever_way_it_came) {
  // From 10¹² sizes away, the place of a hit is known no better than the length of the way allows; the point that trace
  // returns is.
  Random random(504);
  CsgScene scene;
  scene.database.objects = {scene.solid(sphere({0.1, 0.2, 0.3}, 1))};
  ObjectQueries queries;
  for (int turn = 0; turn < 300; ++turn) {
    const Vec3 direction = random.direction();
    const Vec3 origin = random.in_cube(0.5) - direction * std::pow(10, random.uniform(0, 12));
    const auto hit = queries.trace(scene.database, scene.database.objects[0], origin, direction).point;
    if (!hit) continue;
    EXPECT_NEAR((hit->position - Vec3(0.1, 0.2, 0.3)).length(), 1, 0x1p-45);
  }
}

TEST(WalkByTrace, counts_a_wall_between_members_of_a_union_once) {
  CsgScene scene;
  scene.database.objects = {scene.group(
      Operation::unite, {scene.solid(box(Vec3(-1), {0.1, 1, 1})), scene.solid(box({0.1, -1, -1}, Vec3(1)))})};
  EXPECT_EQ(walked(scene, {-5, 0.2, 0.3}, {1, 0, 0}).size(), 3u);
}

TEST(WalkByTrace, passes_a_leaf_that_is_thinner_than_the_least_distance_as_a_whole) {
  for (const double thickness : {1e-14, 1e-11}) {
    CsgScene scene;
    scene.database.objects = {scene.solid(box(Vec3(1), Vec3(2, 1 + thickness, 2)))};
    EXPECT_EQ(walked(scene, {1.5, 5, 1.5}, {0, -1, 0}).size(), thickness < 1e-12 ? 0u : 2u) << thickness;
  }
}

}  // namespace
}  // namespace isl::render::test
