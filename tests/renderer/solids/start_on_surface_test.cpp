// Rays that start on a surface do not meet it again at the start, and meet it where they must. There are no offsets, so
// there are no gaps.
#include "tests/renderer/solids/solid_oracle.h"

#include <gtest/gtest.h>

namespace isl::render::test {
namespace {

using scene::Solid;
using scene::SolidKind;

struct Start {
  Vec3 point;
  std::uint32_t part;
};

/// Finds the point where a random line first meets the solid.
bool random_start(const Solid& solid, Random& random, Start& start) {
  const Vec3 direction = random.direction();
  const Vec3 origin = random.in_cube(1.5) - direction * 4.0;
  const Crossings found = crossings(solid, origin, direction, kNoPart);
  if (found.count == 0) return false;
  start = {origin + direction * found.t[0], found.part[0]};
  return true;
}

double random_lean(Random& random) { return std::pow(10, random.uniform(-14, -0.5)); }

TEST(RaysFromASurface, never_meet_it_again_when_they_leave_a_convex_solid) {
  Random random(11);
  int starts = 0;
  while (starts < 100000) {
    for (const SolidKind kind : kAllKinds) {
      const Solid solid = random_solid(random, kind);
      Start start;
      if (!random_start(solid, random, start)) continue;
      const Vec3 out = leaning(normal_at(solid, start.part, start.point), random_lean(random), random);
      ASSERT_EQ(positive(crossings(solid, start.point, out, start.part)), 0) << "kind " << static_cast<int>(kind);
      ++starts;
    }
  }
}

TEST(RaysFromASurface, leave_a_closed_solid_exactly_once_when_they_enter_it) {
  Random random(12);
  int starts = 0;
  int tiny = 0;
  while (starts < 100000) {
    for (const SolidKind kind : {SolidKind::sphere, SolidKind::cylinder, SolidKind::cone}) {
      const Solid solid = random_solid(random, kind);
      Start start;
      if (!random_start(solid, random, start)) continue;
      const double lean = random_lean(random);
      const Vec3 in = leaning(normal_at(solid, start.part, start.point), -lean, random);
      const Crossings found = crossings(solid, start.point, in, start.part);
      // Within rounding of an edge or an apex, the entry may already be the exit.
      if (positive(found) == 0) {
        ++tiny;
        continue;
      }
      ASSERT_EQ(positive(found), 1) << "kind " << static_cast<int>(kind);
      const double t = found.t[found.count - 1];
      ASSERT_NEAR(static_cast<double>(signed_gap(solid, along(start.point, in, t))), 0, 1e-12 * (1 + t));
      ASSERT_LT(static_cast<double>(signed_gap(solid, along(start.point, in, t / 2))), 1e-14);
      ++starts;
    }
  }
  EXPECT_LT(tiny, 10);
}

TEST(RaysFromASurface, meet_a_sphere_again_at_the_end_of_the_chord) {
  Random random(13);
  const Solid solid{SolidKind::sphere, false, {0, 0, 0}, Vec3(0), 1, 0};
  for (int i = 0; i < 10000; ++i) {
    const Vec3 normal = random.direction();
    const double lean = random_lean(random);
    const Vec3 in = leaning(normal, -lean, random);
    const Crossings found = crossings(solid, normal, in, 0);
    ASSERT_EQ(found.count, 1);
    // The chord is 2 sin(lean), correct to the last digit that a direction of unit length in doubles can express.
    EXPECT_NEAR(found.t[0], -2 * normal.dot(in), 1e-15);
    EXPECT_GT(found.t[0], 0);
  }
}

TEST(RaysFromASurface, within_a_cap_or_along_a_side_meet_nothing) {
  const Solid cylinder{SolidKind::cylinder, false, {0, 0, 0}, {0, 2, 0}, 1, 0};
  EXPECT_EQ(positive(crossings(cylinder, {0.5, 2, 0}, {1, 0, 0}, 2)), 0);
  EXPECT_EQ(positive(crossings(cylinder, {0.5, 0, 0}, {1, 0, 0}, 1)), 0);
  EXPECT_EQ(positive(crossings(cylinder, {1, 1, 0}, {0, 0, 1}, 0)), 0);
  const Solid cone{SolidKind::cone, false, {0, 0, 0}, {0, 1, 0}, 1, 0};
  EXPECT_EQ(positive(crossings(cone, {0.5, 0.5, 0}, {0, 0, 1}, 0)), 0);
  EXPECT_EQ(positive(crossings(cone, {1, 0, 0}, {-1, 1, 0}, 0)), 0) << "along the generator";
}

TEST(RaysFromASurface, go_through_from_cap_to_cap) {
  const Solid cylinder{SolidKind::cylinder, false, {0, 0, 0}, {0, 2, 0}, 1, 0};
  const Crossings found = crossings(cylinder, {0.25, 0, 0.25}, {0, 1, 0}, 1);
  ASSERT_EQ(found.count, 1);
  EXPECT_EQ(found.t[0], 2);
  EXPECT_EQ(found.part[0], 2);
}

TEST(RaysFromASurface, cross_an_open_tube_to_its_other_side) {
  Solid tube{SolidKind::cylinder, true, {0, 0, 0}, {0, 2, 0}, 1, 0};
  const Crossings across = crossings(tube, {1, 1, 0}, {-1, 0.25, 0}, 0);
  ASSERT_EQ(across.count, 1);
  EXPECT_EQ(across.t[0], 2);
  EXPECT_EQ(crossings(tube, {1, 1, 0}, {-1, 1, 0}, 0).count, 0) << "out through the open end";
}

}  // namespace
}  // namespace isl::render::test
