// The reference tracer, compared with closed forms of the hard cases that have one. Names contain the case's number.
#include "renderer/reference/reference_tracer.h"

#include "tests/reference/near.h"
#include "tests/reference/random_scenes.h"
#include "tests/reference/small_scenes.h"

#include <gmock/gmock.h>

#include <cmath>

namespace isl::reference {
namespace {

using scene::Vec3;
using testing::IsEmpty;
using testing::SizeIs;

/// All roots of the database's blob along a line.
RayRoots roots(const scene::Database& database, const Vec3& origin, const Vec3& direction,
               const RootOptions& options = {}) {
  return roots_along(ReferenceField(database, database.blobs[0]), {interval_of(origin), interval_of(direction)},
                     options);
}

void expect_roots(const RayRoots& found, const std::vector<long double>& expected, long double tolerance) {
  ASSERT_THAT(found.crossings, SizeIs(expected.size()));
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_CLOSE(found.crossings[i].t, expected[i], tolerance) << "root " << i;
    EXPECT_EQ(found.crossings[i].entering, (i % 2 == 0) != found.starts_inside) << "root " << i;
  }
}

TEST(ReferenceTracer, A01_GrazingRayFindsTwoRootsOrMisses) {
  for (const scene::Kernel& kernel : every_kernel(4)) {
    const scene::Database ball = one_blob(kernel, {point({0, 0, 0}, 1)});
    for (const double epsilon : {1e-2, 1e-4, 1e-8, 1e-12, 1e-14, 1e-15}) {
      const double d = 1 - epsilon;
      const long double half = std::sqrt((1 - static_cast<long double>(d)) * (1 + static_cast<long double>(d)));
      SCOPED_TRACE(epsilon);
      // The tolerance is F's own error, 1e-17, over its slope at the root, 8·half.
      expect_roots(roots(ball, {0, d, -8}, {0, 0, 1}), {8 - half, 8 + half}, 1e-17L + 1e-17L / half);
    }
    EXPECT_THAT(roots(ball, {0, 1 + 1e-12, -8}, {0, 0, 1}).crossings, IsEmpty());
    EXPECT_THAT(roots(ball, {0, 1, -8}, {0, 0, 1}).crossings, IsEmpty());
  }
}

TEST(ReferenceTracer, A02_DoubleRootInsideIsATouchAndNoCrossing) {
  // Two POV-Ray spheres at ±3/4: each is (7/16)² in the middle, exactly.
  const double middle = 2 * 0.4375 * 0.4375;
  const std::vector<scene::Component> pair = {point({-0.75, 0, 0}, 1), point({0.75, 0, 0}, 1)};
  const RayRoots exact = roots(one_blob(kPovRay, pair, middle), {-4, 0, 0}, {1, 0, 0});
  EXPECT_THAT(exact.crossings, SizeIs(2));
  ASSERT_THAT(exact.touches, SizeIs(1));
  // Within √(16e-18/2.75) the square x² is less than some roundings of F, 1e-18 each.
  EXPECT_CLOSE(exact.touches[0].begin, 4, 4e-8L);
  EXPECT_CLOSE(exact.touches[0].end, 4, 4e-8L);
  EXPECT_THAT(roots(one_blob(kPovRay, pair, middle * (1 - 1e-9)), {-4, 0, 0}, {1, 0, 0}).crossings, SizeIs(2));

  const double above = middle * (1 + 1e-9);
  const RayRoots four = roots(one_blob(kPovRay, pair, above), {-4, 0, 0}, {1, 0, 0});
  ASSERT_THAT(four.crossings, SizeIs(4));
  // On the axis F = 2x⁴ + x²(12c² − 4) + 2(1 − c²)² − T with c² = 9/16: a quadratic in x².
  const long double b = 12 * 0.5625L - 4, rest = static_cast<long double>(above) - middle;
  const long double x = std::sqrt((-b + std::sqrt(b * b + 8 * rest)) / 4);
  // F is correct to 1e-18 and its slope there is 6e-5.
  EXPECT_CLOSE(four.crossings[1].t, 4 - x, 5e-14L);
  EXPECT_CLOSE(four.crossings[2].t, 4 + x, 5e-14L);
}

TEST(ReferenceTracer, E43_LongSegmentHasItsSurfaceAtItsRadius) {
  for (const scene::Kernel& kernel : {quartic(0.5), quartic(4), quartic(500), cauchy(0.5), cauchy(4), cauchy(500)}) {
    for (const double half : {1e2, 1e5, 1e9}) {
      const scene::Database limb = one_blob(convolved(kernel), {segment({-half, 0, 0}, {half, 0, 0}, 1)});
      const RayRoots found = roots(limb, {0.25, 0, -4}, {0, 0, 1});
      SCOPED_TRACE(testing::Message() << kernel.hardness << " " << half);
      EXPECT_THAT(found.touches, IsEmpty());
      expect_roots(found, {3, 5}, 1e-15L);
    }
  }
}

TEST(ReferenceTracer, TheSideARayComesFromTellsACrossingAtItsStartFromATouch) {
  // (1 − r²)² is 9/16 at r = 1/2, exactly: rounding hides on which side the start lies.
  const scene::Database ball = one_blob(kPovRay, {point({0, 0, 0}, 1)}, 0.5625);
  const Vec3 start{0, 0, -0.5}, inwards{0, 0, 1}, outwards{0, 0, -1};
  const RayRoots entering = roots(ball, start, inwards, {.coming_from = -1});
  expect_roots(entering, {0, 1}, 1e-17L);
  EXPECT_FALSE(entering.starts_inside);
  EXPECT_THAT(entering.touches, IsEmpty());
  const RayRoots leaving = roots(ball, start, outwards, {.coming_from = 1});
  expect_roots(leaving, {0}, 1e-17L);
  EXPECT_TRUE(leaving.starts_inside);
  EXPECT_THAT(leaving.touches, IsEmpty());
  for (const int coming_from : {0, 1})
    EXPECT_THAT(roots(ball, start, inwards, {.coming_from = coming_from}).touches, SizeIs(1)) << coming_from;
}

TEST(ReferenceTracer, A03_QuadrupleRoot) {
  // With c² = 1/3 the same quadratic has no middle term: F = 2x⁴ + 8/9 − T.
  const double c = std::sqrt(1.0 / 3.0);
  const long double b = 12 * static_cast<long double>(c) * c - 4, rest = 1 - static_cast<long double>(c) * c;
  const std::vector<scene::Component> pair = {point({-c, 0, 0}, 1), point({c, 0, 0}, 1)};
  const double middle = static_cast<double>(2 * rest * rest);
  const double above = middle * (1 + 1e-12);
  const long double gap = static_cast<long double>(above) - 2 * rest * rest;
  const long double x = std::sqrt((-b + std::sqrt(b * b + 8 * gap)) / 4);
  const RayRoots four = roots(one_blob(kPovRay, pair, above), {-4, 0, 0}, {1, 0, 0});
  ASSERT_THAT(four.crossings, SizeIs(4));
  EXPECT_CLOSE(four.crossings[1].t, 4 - x, 1e-8L);
  EXPECT_CLOSE(four.crossings[2].t, 4 + x, 1e-8L);
  EXPECT_CLOSE(x, std::pow(4.0L / 9 * 1e-12L, 0.25L), 1e-6L);
  EXPECT_THAT(roots(one_blob(kPovRay, pair, middle * (1 - 1e-12)), {-4, 0, 0}, {1, 0, 0}).crossings, SizeIs(2));
}

TEST(ReferenceTracer, B12_CoincidentBlobsAreOneLargerSphere) {
  const int count = 1000;
  const scene::Database many = one_blob(quartic(4), std::vector<scene::Component>(count, point({0, 0, 0}, 1)));
  // count·(1 + 2(1 − q))² = 1
  const long double radius = std::sqrt(1 + (1 - 1 / std::sqrt(static_cast<long double>(count))) / 2);
  expect_roots(roots(many, {0, 0, -5}, {0, 0, 1}), {5 - radius, 5 + radius}, 1e-15L);
}

TEST(ReferenceTracer, B17_OppositeCoincidentBlobsAreEmpty) {
  const scene::Database none = one_blob(gaussian(4), {point({0, 0, 0}, 1, 3), point({0, 0, 0}, 1, -3)});
  EXPECT_THAT(roots(none, {0.1, 0.2, -5}, {0, 0, 1}).crossings, IsEmpty());
}

TEST(ReferenceTracer, B19_CarvedHoleHasFourRoots) {
  // (3 − 2x²)² − (3 − 8x²)² = 1, that is 36x² − 60x⁴ = 1, while x² < 3/8; beyond, the first sphere alone.
  const scene::Database carved = one_blob(quartic(4), {point({0, 0, 0}, 1), point({0, 0, 0}, 0.5, -1)});
  const long double inner = std::sqrt((36 - std::sqrt(36.0L * 36 - 240)) / 120);
  expect_roots(roots(carved, {0, 0, -5}, {0, 0, 1}), {4, 5 - inner, 5 + inner, 6}, 1e-17L * 64);
  EXPECT_THAT(
      roots(one_blob(gaussian(4), {point({0, 0, 0}, 1), point({0, 0, 0}, 0.5, -1)}), {0, 0, -5}, {0, 0, 1}).crossings,
      SizeIs(4));
}

TEST(ReferenceTracer, B20_NegativeFieldsAloneAreEmpty) {
  EXPECT_THAT(roots(one_blob(gaussian(4), {point({0, 0, 0}, 1, -2)}), {0, 0, -5}, {0, 0, 1}).crossings, IsEmpty());
}

TEST(ReferenceTracer, B21_ThresholdNextToTheMaximumLeavesATinySphere) {
  const double below = 1 - 1e-12;
  const long double radius = std::sqrt(1 - std::sqrt(static_cast<long double>(below)));
  const std::vector<scene::Component> ball = {point({0, 0, 0}, 1)};
  expect_roots(roots(one_blob(kPovRay, ball, below), {0, 0, -5}, {0, 0, 1}), {5 - radius, 5 + radius}, 1e-12L);
  EXPECT_THAT(roots(one_blob(kPovRay, ball, 1), {0, 0, -5}, {0, 0, 1}).crossings, IsEmpty());
  EXPECT_THAT(roots(one_blob(kPovRay, ball, 1 + 1e-12), {0, 0, -5}, {0, 0, 1}).crossings, IsEmpty());
}

TEST(ReferenceTracer, B22_TinyThresholdReachesAlmostToTheSupport) {
  const double tiny = 1e-12;
  const long double radius = std::sqrt(1 - std::sqrt(static_cast<long double>(tiny)));
  expect_roots(roots(one_blob(kPovRay, {point({0, 0, 0}, 1)}, tiny), {0, 0, -5}, {0, 0, 1}), {5 - radius, 5 + radius},
               1e-14L);
}

TEST(ReferenceTracer, B24_ChainOfBlobsHasAllItsRoots) {
  std::vector<scene::Component> chain;
  for (int i = 0; i < 300; ++i) chain.push_back(point({0, 0, 4.0 * i}, 1));
  std::vector<long double> expected;
  for (int i = 0; i < 300; ++i) expected.insert(expected.end(), {4.0L * i + 9, 4.0L * i + 11});
  expect_roots(roots(one_blob(gaussian(4), chain), {0, 0, -10}, {0, 0, 1}), expected, 1e-15L);
}

TEST(ReferenceTracer, C26_ScalingByPowersOfTwoScalesTheRoots) {
  RandomSource random(3);
  for (int scene = 0; scene < 10; ++scene) {
    const scene::Database database = random_blob(random, {.components = 8, .transforms = false});
    const LineOfSight line = random_line(random, 3, 0.5);
    const RayRoots plain = roots(database, line.origin, line.direction);
    for (const int k : {-30, -1, 7, 30}) {
      const double factor = std::ldexp(1.0, k);
      const RayRoots large = roots(scaled(database, factor), line.origin * factor, line.direction);
      ASSERT_THAT(large.crossings, SizeIs(plain.crossings.size()));
      for (std::size_t i = 0; i < plain.crossings.size(); ++i) {
        EXPECT_EQ(large.crossings[i].t, plain.crossings[i].t * factor) << "scene " << scene << ", root " << i;
      }
    }
  }
}

TEST(ReferenceTracer, D37_RayFromInsideLeavesFirst) {
  const scene::Database ball = one_blob(gaussian(4), {point({0, 0, 0}, 1)});
  const RayRoots inside = roots(ball, {0, 0, 0.25}, {0, 0, 1});
  EXPECT_TRUE(inside.starts_inside);
  expect_roots(inside, {0.75L}, 1e-17L);
  EXPECT_THAT(roots(ball, {0, 0, 0.25}, {0, 0, 1}, {.t_max = 0.74L}).crossings, IsEmpty());
}

TEST(ReferenceTracer, D38_RayFromTheSurfaceForgetsWhereItStarts) {
  const scene::Database ball = one_blob(gaussian(4), {point({0, 0, 0}, 1)});
  RandomSource random(5);
  for (int i = 0; i < 200; ++i) {
    const Vec3 start = random.direction(), direction = random.direction();
    const RayRoots found = roots(ball, start, direction, {.starts_on_root = true});
    // The expected chord is that of the ball itself: the start lies on it only up to a rounding, which matters for a
    // short chord.
    const long double back = dot(exactly(start), exactly(direction)), length2 = squared_length(exactly(direction));
    const long double off = squared_length(exactly(start)) - 1;
    const long double chord = (std::sqrt(back * back - length2 * off) - back) / length2;
    if (back > 0) {
      EXPECT_THAT(found.crossings, IsEmpty());
    } else {
      EXPECT_TRUE(found.starts_inside);
      expect_roots(found, {chord}, 1e-15L);
    }
  }
}

TEST(ReferenceTracer, F56_RayFromTheSurfaceFindsASurfaceVeryNear) {
  // The inner roots of A02 are about 2e-5 apart.
  const double threshold = 2 * 0.4375 * 0.4375 * (1 + 1e-9);
  const scene::Database pair = one_blob(kPovRay, {point({-0.75, 0, 0}, 1), point({0.75, 0, 0}, 1)}, threshold);
  const RayRoots four = roots(pair, {-4, 0, 0}, {1, 0, 0});
  ASSERT_THAT(four.crossings, SizeIs(4));
  const double start = static_cast<double>(four.crossings[1].t - 4);
  const RayRoots rest = roots(pair, {start, 0, 0}, {1, 0, 0}, {.starts_on_root = true});
  EXPECT_FALSE(rest.starts_inside);
  ASSERT_THAT(rest.crossings, SizeIs(2));
  EXPECT_CLOSE(rest.crossings[0].t, -2 * static_cast<long double>(start), 1e-13L);
}

TEST(ReferenceTracer, E43_SegmentWithoutLengthIsAPoint) {
  const scene::Database dot_like = one_blob(gaussian(4), {segment({1, 0, 0}, {1, 0, 0}, 0.5)});
  expect_roots(roots(dot_like, {1, 0, -5}, {0, 0, 1}), {4.5L, 5.5L}, 1e-17L * 16);
}

TEST(ReferenceTracer, E44_SegmentAlongAcrossAndBesideItsAxis) {
  const scene::Database limb = one_blob(gaussian(4), {segment({0, 0, 0}, {2, 0, 0}, 0.5)});
  expect_roots(roots(limb, {-4, 0, 0}, {1, 0, 0}), {3.5L, 6.5L}, 1e-16L);
  expect_roots(roots(limb, {1, 0, -4}, {0, 0, 1}), {3.5L, 4.5L}, 1e-16L);
  expect_roots(roots(limb, {-4, 0.3, 0}, {1, 0, 0}), {3.6L, 6.4L}, 1e-15L);
  EXPECT_THAT(roots(limb, {-4, 0.5 + 1e-12, 0}, {1, 0, 0}).crossings, IsEmpty());
}

TEST(ReferenceTracer, ConeHasItsEndSpheresAndItsSlantedFlank) {
  const scene::Database limb = one_blob(quartic(4), {cone({0, 0, 0}, 0.5, {2, 0, 0}, 0.25)});
  expect_roots(roots(limb, {-4, 0, 0}, {1, 0, 0}), {3.5L, 6.25L}, 1e-16L);
  // At q = 1, ρ² = A² + k²ρ², with A the radius that the axis has there: ρ = A/√(1 − k²).
  const long double k = -0.125L, radius = (0.5L + k) / std::sqrt(1 - k * k);
  expect_roots(roots(limb, {1, 0, -4}, {0, 0, 1}), {4 - radius, 4 + radius}, 1e-16L);
}

TEST(ReferenceTracer, BoxHasItsFacesAndItsRoundEdges) {
  const scene::Database solid = one_blob(quartic(4), {box({-1, -0.5, -2}, {1, 0.5, 2}, 0.25)});
  expect_roots(roots(solid, {0.25, 0, -4}, {0, 0, 1}), {1.75L, 6.25L}, 1e-16L);
  expect_roots(roots(solid, {0, 0, 0}, {0, 1, 0}), {0.75L}, 1e-16L);
  // At 0.15 beside the box, the line meets the round edges at √(0.25² − 0.15²) = 0.2 beyond its ends.
  const long double x = scene::Vec3(1.15).x - 1.0L, edge = std::sqrt(0.0625L - x * x);
  expect_roots(roots(solid, {1.15, 0, -4}, {0, 0, 1}), {2 - edge, 6 + edge}, 1e-16L);
  const scene::Database flat = one_blob(cauchy(4), {box({-1, 0, -1}, {1, 0, 1}, 0.25)});
  expect_roots(roots(flat, {0.3, -4, 0.2}, {0, 1, 0}), {3.75L, 4.25L}, 1e-16L);
}

TEST(ReferenceTracer, TriangleHasItsFaceItsEdgesAndItsCorners) {
  scene::Database flat = one_blob(gaussian(4), {triangle({-1, 0, 0}, {1, 0, 0}, 0.25)});
  flat.blobs[0].corners = {scene::Vec3(0, 0, 1)};
  expect_roots(roots(flat, {0, -4, 0.5}, {0, 1, 0}), {3.75L, 4.25L}, 1e-16L);
  expect_roots(roots(flat, {0, 0, -4}, {0, 0, 1}), {3.75L, 5.25L}, 1e-16L);
  expect_roots(roots(flat, {-4, 0, 0}, {1, 0, 0}), {2.75L, 5.25L}, 1e-16L);
  // The line is 0.125/√2 outside the slanted edge x + z = 1.
  const long double half = std::sqrt(0.0625L - 0.125L * 0.125L / 2);
  expect_roots(roots(flat, {0.5, -4, 0.625}, {0, 1, 0}), {4 - half, 4 + half}, 1e-16L);
}

TEST(ReferenceTracer, TriangleWithoutAreaIsTheSegmentOrPointThatIsLeft) {
  scene::Database line = one_blob(gaussian(4), {triangle({-1, 0, 0}, {1, 0, 0}, 0.25)});
  line.blobs[0].corners = {scene::Vec3(0.5, 0, 0)};
  expect_roots(roots(line, {0.3, -4, 0}, {0, 1, 0}), {3.75L, 4.25L}, 1e-16L);
  expect_roots(roots(line, {-4, 0, 0}, {1, 0, 0}), {2.75L, 5.25L}, 1e-16L);
  scene::Database place = one_blob(gaussian(4), {triangle({1, 0, 0}, {1, 0, 0}, 0.25)});
  place.blobs[0].corners = {scene::Vec3(1, 0, 0)};
  expect_roots(roots(place, {-4, 0, 0}, {1, 0, 0}), {4.75L, 5.25L}, 1e-16L);
}

TEST(ReferenceTracer, CircleHasItsHole) {
  const scene::Database ring = one_blob(metaball(4), {circle({0, 0, 0}, {0, 1, 0}, 1, 0.25)});
  expect_roots(roots(ring, {-4, 0, 0}, {1, 0, 0}), {2.75L, 3.25L, 4.75L, 5.25L}, 1e-16L);
  expect_roots(roots(ring, {1, -4, 0}, {0, 1, 0}), {3.75L, 4.25L}, 1e-16L);
  EXPECT_THAT(roots(ring, {0, -4, 0}, {0, 1, 0}).crossings, IsEmpty());
  // Beside the axis, ρ = 1 ± 0.25 is at x = √(ρ² − 0.5²).
  const long double inner = std::sqrt(0.5625L - 0.25L), outer = std::sqrt(1.5625L - 0.25L);
  expect_roots(roots(ring, {-4, 0, 0.5}, {1, 0, 0}), {4 - outer, 4 - inner, 4 + inner, 4 + outer}, 1e-16L);
}

TEST(ReferenceTracer, EverySignChangeOfADenseScanHasItsRoot) {
  RandomSource random(17);
  std::size_t total = 0;
  for (int scene = 0; scene < 25; ++scene) {
    const scene::Database database = random_blob(random, {.components = 30});
    const ReferenceField field(database, database.blobs[0]);
    const LineOfSight line = random_line(random, 2, 0.6);
    const RayRoots found = roots(database, line.origin, line.direction);
    ASSERT_THAT(found.touches, IsEmpty());
    const auto crossings_before = [&](long double t) {
      return std::count_if(found.crossings.begin(), found.crossings.end(), [t](const Crossing& c) { return c.t < t; });
    };
    for (int i = 0; i < 1000; ++i) {
      const long double t = i * 4e-3L;
      const bool inside = field.value(exactly(line.origin) + exactly(line.direction) * t) > 0;
      ASSERT_EQ(inside, crossings_before(t) % 2 != 0) << "scene " << scene << " at " << t;
    }
    total += found.crossings.size();
  }
  EXPECT_GT(total, 25U);
}

TEST(ReferenceTracer, LargestValueIsThePeakOnTheRay) {
  const scene::Database ball = one_blob(kPovRay, {point({0, 0, 0}, 1)}, 0.5);
  const ReferenceField field(ball, ball.blobs[0]);
  const FieldOnRay ray(field, {interval_of({0, 0.5, -3}), interval_of({0, 0, 1})});
  const Interval peak = largest_value(ray, 0, 6);
  EXPECT_CLOSE(peak.lo(), 0.0625L, 1e-14L);
  EXPECT_CLOSE(peak.hi(), 0.0625L, 1e-14L);
}

TEST(ReferenceScene, PlacesBlobsThroughGroups) {
  scene::Database database = one_blob(gaussian(4), {point({0, 0, 0}, 1)});
  scene::Object child = database.objects[0];
  child.parent_from_object.matrix.setScale(Vec3(2));
  child.parent_from_object.inverse.setScale(Vec3(0.5));
  database.groups.push_back({.children = {child}});
  scene::Object& group = database.objects.emplace_back();
  group.kind = scene::Object::Kind::group;
  group.shape = 0;
  group.parent_from_object.matrix.setTranslation(Vec3(0, 0, -4));
  group.parent_from_object.inverse.setTranslation(Vec3(0, 0, 4));
  const ReferenceScene scene(database);
  ASSERT_THAT(scene.placed(), SizeIs(2));
  const auto hit = scene.first_hit({0, 0, -10}, {0, 0, 1});
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->placed, 1U);
  EXPECT_CLOSE(hit->crossing.t, 4, 1e-16L);
}

}  // namespace
}  // namespace isl::reference
