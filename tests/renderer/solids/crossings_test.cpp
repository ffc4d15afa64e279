// Crossings lie on the surface, and they separate inside from outside, at every scale and from far away.
#include "tests/renderer/solids/solid_oracle.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace isl::render::test {
namespace {

using scene::Solid;
using scene::SolidKind;

Solid scaled(Solid solid, double scale) {
  if (solid.kind != SolidKind::plane) solid.a *= scale;
  solid.b *= scale;
  solid.radius_a *= scale;
  solid.radius_b *= scale;
  return solid;
}

/// Every crossing is on the surface to 1e-12 of the distances involved, crossings ascend, and samples of other points
/// of the line are inside exactly if the crossings say so.
void expect_consistent(const Solid& solid, const Vec3& origin, const Vec3& direction, Random& random) {
  if (testing::Test::HasFailure()) return;  // the first case says enough
  const Crossings found = crossings(solid, origin, direction, kNoPart);
  const double reach = (origin - (solid.kind == SolidKind::plane ? Vec3(0) : solid.a)).length() + size_of(solid);
  const double tolerance = 1e-12 * reach;
  const int some = solid.kind == SolidKind::plane ? 1 : 2;
  ASSERT_TRUE(found.count == 0 || found.count == some);
  for (int i = 0; i < found.count; ++i) {
    const double far = solid.kind == SolidKind::plane ? std::abs(found.t[i]) * direction.length() : 0;
    ASSERT_NEAR(static_cast<double>(signed_gap(solid, along(origin, direction, found.t[i]))), 0,
                tolerance + 1e-12 * far);
  }
  ASSERT_TRUE(found.count < 2 || found.t[0] < found.t[1]);
  const double middle = (solid.a - origin).dot(direction) / direction.dot(direction);
  for (int i = 0; i < 8; ++i) {
    const double t =
        (solid.kind == SolidKind::plane ? 0 : middle) + random.uniform(-1.5, 1.5) * size_of(solid) / direction.length();
    const double gap = static_cast<double>(signed_gap(solid, along(origin, direction, t)));
    if (std::abs(gap) < tolerance) continue;
    const bool inside = solid.kind == SolidKind::plane
                            ? (found.count == 1 && (direction.dot(solid.a) > 0 ? t < found.t[0] : t > found.t[0]))
                            : (found.count == 2 && found.t[0] < t && t < found.t[1]);
    ASSERT_EQ(inside, gap < 0) << "gap " << gap << " at t " << t << ", kind " << static_cast<int>(solid.kind);
  }
}

TEST(Crossings, are_where_the_solid_begins_and_ends) {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    for (const SolidKind kind : kAllKinds) {
      const Solid solid = random_solid(random, kind);
      const Vec3 aim = random.in_cube(1.5);
      const Vec3 direction = random.direction() * std::exp2(random.uniform(-20, 20));
      expect_consistent(solid, aim - direction.normalized() * random.uniform(-3, 6), direction, random);
    }
  }
}

TEST(Crossings, keep_their_digits_at_every_scale) {
  Random random(2);
  for (int i = 0; i < 5000; ++i) {
    for (const SolidKind kind : kAllKinds) {
      const double scale = std::pow(10, random.uniform(-9, 9));
      const Solid solid = scaled(random_solid(random, kind), scale);
      const Vec3 direction = random.direction();
      expect_consistent(solid, random.in_cube(1.5) * scale - direction * (3 * scale), direction, random);
    }
  }
}

TEST(Crossings, keep_their_digits_from_afar) {
  Random random(3);
  for (int i = 0; i < 5000; ++i) {
    for (const SolidKind kind : {SolidKind::sphere, SolidKind::cylinder, SolidKind::cone}) {
      const Vec3 direction = random.direction();
      expect_consistent(random_solid(random, kind), random.in_cube(1) - direction * std::pow(10, random.uniform(1, 7)),
                        direction, random);
    }
  }
}

TEST(Crossings, of_lines_parallel_to_the_axis_or_across_it) {
  Random random(4);
  for (int i = 0; i < 5000; ++i) {
    for (const SolidKind kind : {SolidKind::cylinder, SolidKind::cone}) {
      const Solid solid = random_solid(random, kind);
      const Vec3 axis = (solid.b - solid.a).normalized();
      expect_consistent(solid, random.in_cube(1.5), axis, random);
      expect_consistent(solid, random.in_cube(1.5), axis.cross(random.direction()).normalized(), random);
      Solid upright = solid;
      upright.b = upright.a + Vec3(0, (solid.b - solid.a).length(), 0);
      expect_consistent(upright, random.in_cube(1.5), Vec3(0, 1, 0), random);
      expect_consistent(upright, random.in_cube(1.5), Vec3(1, 0, 0), random);
    }
  }
}

TEST(Crossings, of_lines_parallel_to_a_cones_generators) {
  Random random(5);
  for (int i = 0; i < 5000; ++i) {
    const Solid solid = random_solid(random, SolidKind::cone);
    const Vec3 axis = (solid.b - solid.a).normalized();
    const Vec3 across = axis.cross(random.direction()).normalized();
    const Vec3 generator = axis * (solid.b - solid.a).length() + across * (solid.radius_b - solid.radius_a);
    expect_consistent(solid, random.in_cube(1.5), generator, random);
  }
}

TEST(Crossings, of_a_line_through_a_cones_apex) {
  Solid solid{SolidKind::cone, false, {0, 0, 0}, {0, 2, 0}, 1, 0};
  Random random(6);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 direction = random.direction();
    expect_consistent(solid, Vec3(0, 2, 0) - direction * 3, direction, random);
  }
}

TEST(Crossings, a_tangent_is_none) {
  EXPECT_EQ(crossings({SolidKind::sphere, false, {0, 0, 0}, Vec3(0), 1, 0}, {-5, 1, 0}, {1, 0, 0}, kNoPart).count, 0);
  const Solid cylinder{SolidKind::cylinder, false, {0, 0, 0}, {0, 2, 0}, 1, 0};
  EXPECT_EQ(crossings(cylinder, {-5, 1, 1}, {1, 0, 0}, kNoPart).count, 0) << "along the side";
  EXPECT_EQ(crossings(cylinder, {-5, 2, 0}, {1, 0, 0}, kNoPart).count, 0) << "within a cap's plane";
  EXPECT_EQ(crossings({SolidKind::plane, false, {0, 1, 0}, Vec3(0), 0, 0}, {0, 0, 0}, {1, 0, 0}, kNoPart).count, 0);
}

TEST(Crossings, near_a_huge_sphere_keep_the_small_distance) {
  const Solid planet{SolidKind::sphere, false, {0, -1e9, 0}, Vec3(0), 1e9, 0};
  const Crossings found = crossings(planet, {0, 1, 0}, {0, -1, 0}, kNoPart);
  ASSERT_EQ(found.count, 2);
  EXPECT_NEAR(found.t[0], 1, 1e-12);
}

TEST(Crossings, of_an_open_tube_are_its_side_only) {
  Random random(7);
  int seen[3] = {0, 0, 0};
  for (int i = 0; i < 20000; ++i) {
    for (const SolidKind kind : {SolidKind::cylinder, SolidKind::cone}) {
      Solid solid = random_solid(random, kind);
      const Vec3 origin = random.in_cube(2);
      const Vec3 direction = random.direction();
      const Crossings closed = crossings(solid, origin, direction, kNoPart);
      solid.open = true;
      const Crossings open = crossings(solid, origin, direction, kNoPart);
      ++seen[open.count];
      int expected = 0;
      for (int k = 0; k < closed.count; ++k) {
        if (closed.part[k] != 0) continue;
        ASSERT_LT(expected, open.count);
        EXPECT_EQ(open.t[expected], closed.t[k]);
        EXPECT_EQ(open.part[expected], 0);
        ++expected;
      }
      EXPECT_EQ(open.count, expected);
    }
  }
  EXPECT_GT(std::min({seen[0], seen[1], seen[2]}), 100) << "the rays should include every case";
}

TEST(Crossings, of_a_solid_without_extent_are_none) {
  EXPECT_EQ(crossings({SolidKind::cylinder, false, {1, 1, 1}, {1, 1, 1}, 1, 1}, {0, 1, 1}, {1, 0, 0}, kNoPart).count,
            0);
  EXPECT_EQ(crossings({SolidKind::cone, false, {1, 1, 1}, {1, 1, 1}, 1, 0}, {0, 1, 1}, {1, 0, 0}, kNoPart).count, 0);
  EXPECT_EQ(crossings({SolidKind::sphere, false, {1, 1, 1}, Vec3(0), 0, 0}, {0, 1, 1}, {1, 0, 0}, kNoPart).count, 0);
}

RC_GTEST_PROP(Crossings, move_along_with_the_origin, ()) {
  Random random(*rc::gen::arbitrary<unsigned>());
  const Solid solid =
      random_solid(random, *rc::gen::elementOf(std::vector<SolidKind>(std::begin(kAllKinds), std::end(kAllKinds))));
  const Vec3 origin = random.in_cube(2);
  const Vec3 direction = random.direction();
  const double shift = *rc::gen::inRange(-8, 9);
  const Crossings here = crossings(solid, origin, direction, kNoPart);
  const Crossings there = crossings(solid, origin + direction * shift, direction, kNoPart);
  // Grazing lines may fall on either side of tangency; the others must agree up to the conditioning of a chord.
  if (here.count == 2 && here.t[1] - here.t[0] < 1e-5) return;
  if (there.count == 2 && there.t[1] - there.t[0] < 1e-5) return;
  RC_ASSERT(here.count == there.count);
  for (int i = 0; i < here.count; ++i)
    RC_ASSERT(std::abs(there.t[i] + shift - here.t[i]) < 1e-8 * (1 + std::abs(here.t[i])));
}

}  // namespace
}  // namespace isl::render::test
