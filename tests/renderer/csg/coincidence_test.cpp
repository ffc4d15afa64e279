// Faces that coincide, surfaces that touch, and rays that start on them.
#include "tests/renderer/csg/csg_scene.h"

#include <gtest/gtest.h>

namespace isl::render::test {
namespace {

/// Lines at all angles through the unit cube, some of them far away, some along the axes.
struct Line {
  Vec3 origin, direction;
};
std::vector<Line> lines(unsigned seed, int count) {
  Random random(seed);
  std::vector<Line> result;
  for (int i = 0; i < count; ++i) {
    Vec3 direction = random.direction();
    if (i % 5 == 0) {
      direction = Vec3(0);
      direction[i / 5 % 3] = i % 2 == 0 ? 1 : -1;
    }
    result.push_back({random.in_cube(0.95) - direction * (i % 7 == 0 ? 1e5 : 5), direction});
  }
  return result;
}

std::size_t count_hits(const CsgScene& scene, const Line& line) {
  const Tracer tracer(scene.database, {});
  return walk(tracer, line.origin, line.direction).t.size();
}

scene::Transform turned(double degrees) {
  scene::Matrix rotation, shift;
  rotation.setAxisAngle(Vec3(1, 2, -0.5).normalized(), degrees * M_PI / 180);
  shift.setTranslation(Vec3(0.1, 0.2, 0.3));
  return affine(rotation * shift);
}

/// Tests an operation on two equal objects, each with its own transform of the same meaning. `empty`: nothing is left.
void expect_hits_of_equals(Operation operation, const scene::Solid& solid, const scene::Transform& transform,
                           bool empty) {
  CsgScene both, alone;
  Object a = both.solid(solid), b = both.solid(solid);
  a.parent_from_object = transform;
  // Two transforms to the same place that are rounded differently.
  scene::Matrix there, back;
  there.setTranslation(Vec3(0.3, 0.7, -0.1));
  back.setTranslation(Vec3(-0.3, -0.7, 0.1));
  b.parent_from_object = then(then(affine(there), affine(back)), transform);
  both.database.objects = {both.group(operation, {a, b})};
  Object c = alone.solid(solid);
  c.parent_from_object = transform;
  alone.database.objects = {c};
  const Tracer tracer(both.database, {}), plain(alone.database, {});
  for (const Line& line : lines(71, 3000)) {
    const std::size_t found = walk(tracer, line.origin, line.direction).t.size();
    const Walk expected = walk(plain, line.origin, line.direction);
    // If the line only grazes, rounding may decide differently for the two objects.
    if (expected.t.size() == 2 && expected.t[1] - expected.t[0] < 1e-6) continue;
    ASSERT_EQ(found, empty ? 0 : expected.t.size()) << line.origin << " " << line.direction;
  }
}

scene::Solid solid_of(scene::SolidKind kind) {
  switch (kind) {
    case scene::SolidKind::box: return box({-0.5, -0.4, -0.6}, {0.7, 0.5, 0.4});
    case scene::SolidKind::sphere: return sphere({0.1, 0, 0.2}, 0.7);
    default: break;
  }
  scene::Solid solid = box({-0.2, -0.5, 0}, {0.1, 0.6, 0.2});
  solid.kind = kind;
  solid.radius_a = kind == scene::SolidKind::torus ? 0.6 : 0.5;
  solid.radius_b = 0.2;
  return solid;
}

constexpr scene::SolidKind kKinds[] = {scene::SolidKind::box,  scene::SolidKind::sphere, scene::SolidKind::cylinder,
                                       scene::SolidKind::cone, scene::SolidKind::torus,  scene::SolidKind::ovus};

TEST(Coincidence, of_a_solid_with_itself_leaves_nothing_of_a_difference) {
  for (const scene::SolidKind kind : kKinds) {
    expect_hits_of_equals(Operation::subtract, solid_of(kind), {}, true);
    expect_hits_of_equals(Operation::subtract, solid_of(kind), turned(33), true);
  }
}

TEST(Coincidence, of_a_solid_with_itself_is_the_solid) {
  for (const scene::SolidKind kind : kKinds) {
    for (const Operation operation : {Operation::intersect, Operation::merge}) {
      expect_hits_of_equals(operation, solid_of(kind), {}, false);
      expect_hits_of_equals(operation, solid_of(kind), turned(33), false);
    }
  }
}

TEST(Coincidence, of_an_open_frames_faces_leaves_no_skin) {
  // A box with a hole from face to face: a line along the hole meets nothing, and one beside it meets two faces.
  CsgScene scene;
  const Object frame = scene.group(
      Operation::subtract, {scene.solid(box(Vec3(-1), Vec3(1))), scene.solid(box({-0.5, -1, -0.5}, {0.5, 1, 0.5}))});
  for (const double degrees : {0.0, 33.0}) {
    Object placed = frame;
    placed.parent_from_object = turned(degrees);
    scene.database.objects = {placed};
    const Tracer tracer(scene.database, {});
    Random random(72);
    for (int i = 0; i < 3000; ++i) {
      const Vec3 through(random.uniform(-0.49, 0.49), 0, random.uniform(-0.49, 0.49));
      const Vec3 down = placed.parent_from_object.vector({0, -1, 0});
      const Vec3 from = placed.parent_from_object.point(through + Vec3(0, random.uniform(1.5, 1000), 0));
      ASSERT_EQ(walk(tracer, from, down).t.size(), 0u) << degrees << " " << through;
      const Vec3 lean = random.direction();
      const Vec3 at = placed.parent_from_object.point(through + Vec3(0, 0.9999, 0));
      const Walk found = walk(tracer, at - lean * 5, lean);
      ASSERT_EQ(found.t.size() % 2, 0u);
    }
  }
}

TEST(Coincidence, of_two_boxes_side_by_side_merges_without_a_wall) {
  CsgScene scene;
  scene.database.objects = {scene.group(
      Operation::merge, {scene.solid(box(Vec3(-1), {0.1, 1, 1})), scene.solid(box({0.1, -1, -1}, Vec3(1)))})};
  for (const Line& line : lines(73, 2000)) {
    const std::size_t hits = count_hits(scene, line);
    ASSERT_TRUE(hits == 2) << hits << " at " << line.origin << " " << line.direction;
  }
}

/// The leaf of `root` that a ray along z meets at z = 0. Leaves are counted in the order in which they stand there.
std::uint32_t leaf_met(CsgScene& scene, const Object& root) {
  scene.database.objects = {root};
  const Tracer tracer(scene.database, {});
  Ray ray;
  ray.origin = {0.1, 0.2, -5};
  ray.direction = {0, 0, 1};
  Hit hit;
  TraceCounters counters;
  tracer.first_hits({&ray, 1}, {&hit, 1}, counters, RayKind::image);
  EXPECT_NEAR(hit.t, 5, 1e-9);
  return hit.leaf;
}

TEST(Coincidence, shows_the_later_child_of_an_intersection_and_the_earlier_one_of_a_union_within) {
  CsgScene scene;
  const Object wide = scene.solid(box({-2, -2, 0}, {2, 2, 1})), tall = scene.solid(box({-1, -3, 0}, {1, 3, 2}));
  const Object deep = scene.solid(box({-3, -3, -1}, {3, 3, 5}));
  Object turned_tall = tall;
  turned_tall.parent_from_object = affine(scene::Matrix().setAxisAngle(Vec3(0, 0, 1), 0.3));
  EXPECT_EQ(leaf_met(scene, scene.group(Operation::intersect, {wide, tall})), 1u);
  EXPECT_EQ(leaf_met(scene, scene.group(Operation::intersect, {wide, turned_tall})), 1u);
  EXPECT_EQ(leaf_met(scene, scene.group(Operation::intersect, {wide, tall, deep})), 1u);
  EXPECT_EQ(leaf_met(scene, scene.group(Operation::merge, {wide, tall})), 0u);
  const Object both = scene.group(Operation::unite, {wide, turned_tall});
  EXPECT_EQ(leaf_met(scene, scene.group(Operation::intersect, {both, deep})), 0u);
  EXPECT_EQ(leaf_met(scene, scene.group(Operation::intersect, {deep, both})), 1u);
  EXPECT_EQ(leaf_met(scene, scene.group(Operation::intersect, {both, wide})), 2u);
}

TEST(Coincidence, of_touching_spheres_keeps_parity) {
  CsgScene scene;
  scene.database.objects = {
      scene.group(Operation::merge, {scene.solid(sphere({-0.5, 0, 0}, 0.5)), scene.solid(sphere({0.5, 0, 0}, 0.5))})};
  const Tracer tracer(scene.database, {});
  Random random(74);
  for (int i = 0; i < 20000; ++i) {
    // Lines close to the point of contact, at all angles.
    const Vec3 direction = random.direction();
    const Vec3 aim = random.in_cube(1) * std::pow(10, random.uniform(-18, -1));
    ASSERT_EQ(walk(tracer, aim - direction * 3, direction).t.size() % 2, 0u);
  }
  // The intersection of two objects that only touch is empty.
  scene.database.groups[0].operation = Operation::intersect;
  const Tracer none(scene.database, {});
  for (int i = 0; i < 5000; ++i) {
    const Vec3 direction = random.direction();
    const Walk found = walk(none, random.in_cube(1) * 1e-9 - direction * 3, direction);
    ASSERT_EQ(found.t.size() % 2, 0u);
  }
}

TEST(StartsOnCombinations, neither_meet_themselves_nor_leak) {
  // A box with a spherical bite and a bored hole, and a blob cut by a plane.
  CsgScene scene;
  scene::Solid bore = solid_of(scene::SolidKind::cylinder);
  bore.a = {-2, 0, 0};
  bore.b = {2, 0, 0};
  bore.radius_a = 0.3;
  const Object bitten = scene.group(Operation::subtract, {scene.solid(box(Vec3(-1), Vec3(1))),
                                                          scene.solid(sphere({0, 1, 0}, 0.8)), scene.solid(bore)});
  std::vector<scene::Component> components(2);
  components[0].radius_a = components[1].radius_a = 1.5;
  components[1].a = {0.6, 0, 0};
  const Object blob =
      scene.group(Operation::intersect, {scene.blob(components, 0.5), scene.solid(plane({0, 1, 0}, 0.2))});
  for (const Object& object : {bitten, blob}) {
    scene.database.objects = {object};
    const Tracer tracer(scene.database, {});
    TraceCounters counters;
    Random random(75);
    int starts = 0;
    while (starts < 10000) {
      const Vec3 direction = random.direction();
      Ray ray{random.in_cube(1) - direction * 5, direction, std::numeric_limits<double>::infinity(), 0, {}};
      Hit hit;
      tracer.first_hits(std::span(&ray, 1), std::span(&hit, 1), counters);
      if (hit.is_miss()) continue;
      SurfacePoint point;
      tracer.surface_at(ray, hit, point);
      ASSERT_LT(point.normal.dot(direction), 1e-9) << "an outward normal faces a ray from outside";
      const Vec3 across = point.normal.cross(random.direction());
      if (!(across.length() > 0.1)) continue;
      ++starts;
      const double lean = (starts % 2 == 0 ? 1 : -1) * std::pow(10, random.uniform(-5, 0));
      const Vec3 onward = (across.normalized() + point.normal * lean).normalized();
      const Tracer& same = tracer;
      Walk found;
      Ray next{point.position, onward, std::numeric_limits<double>::infinity(), hit.t, hit.start()};
      Hit second;
      same.first_hits(std::span(&next, 1), std::span(&second, 1), counters);
      // A step away from the surface, the definition tells the side; at grazing angles only a longer step does.
      const double step = 1e-4 / std::abs(lean);
      if (!second.is_miss() && second.t < 2 * step) continue;
      if (step > 0.01) continue;
      ASSERT_EQ(scene.inside(point.position + onward * step), !second.is_miss() && second.from_inside)
          << point.position << " " << onward << " " << second.t;
    }
  }
}

TEST(StartsOnCombinations, on_coinciding_faces_leave_both) {
  CsgScene scene;
  for (const Operation operation : {Operation::merge, Operation::intersect}) {
    scene.database.objects = {
        scene.group(operation, {scene.solid(box(Vec3(-1), Vec3(1))), scene.solid(box({-1, -1, -1}, {1, 1, 1}))})};
    Object& object = scene.database.objects[0];
    object.parent_from_object = turned(40);
    const Tracer tracer(scene.database, {});
    TraceCounters counters;
    Random random(76);
    for (int i = 0; i < 10000; ++i) {
      const Vec3 direction = random.direction();
      Ray ray{random.in_cube(0.5) - direction * std::pow(10, random.uniform(1, 5)),
              direction,
              std::numeric_limits<double>::infinity(),
              0,
              {}};
      Hit hit;
      tracer.first_hits(std::span(&ray, 1), std::span(&hit, 1), counters);
      if (hit.is_miss()) continue;
      SurfacePoint point;
      tracer.surface_at(ray, hit, point);
      const Vec3 across = point.normal.cross(random.direction());
      if (!(across.length() > 0.1)) continue;
      const double lean = std::pow(10, random.uniform(-5, 0));
      for (const double side : {lean, -lean}) {
        const Vec3 onward = (across.normalized() + point.normal * side).normalized();
        Ray next{point.position, onward, std::numeric_limits<double>::infinity(), hit.t, hit.start()};
        Hit second;
        tracer.first_hits(std::span(&next, 1), std::span(&second, 1), counters);
        ASSERT_EQ(second.is_miss(), side > 0) << side << " " << second.t;
      }
    }
  }
}

}  // namespace
}  // namespace isl::render::test
