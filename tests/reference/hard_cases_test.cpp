// Hard cases of roots, sums and starts through the public tracer, with results in closed form. The case's number is in
// its name.
#include "renderer/reference/reference_kernel.h"
#include "tests/reference/small_scenes.h"
#include "tests/reference/tracer_under_test.h"

#include <gmock/gmock.h>

#include <cmath>

namespace isl::reference {
namespace {

using scene::Vec3;
using testing::IsEmpty;
using testing::SizeIs;

/// The tolerance is that of rounding, because closed forms have all their digits.
render::TracerOptions exact() { return with(render::SolverName::exact, {1e-12, false}); }

void expect_walk(const scene::Database& database, const Vec3& origin, const Vec3& direction,
                 const std::vector<double>& expected, double tolerance) {
  const std::vector<double> found = TracerUnderTest(database, exact()).walk(origin, direction);
  ASSERT_THAT(found, SizeIs(expected.size()));
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], tolerance) << "root " << i;
}

TEST(HardCases, A01_GrazingRayFindsTwoRootsOrMisses) {
  for (const scene::Kernel& kernel : every_kernel(4)) {
    const scene::Database ball = one_blob(kernel, {point({0, 0, 0}, 1)});
    for (const double epsilon : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
      SCOPED_TRACE(epsilon);
      const double d = 1 - epsilon, half = std::sqrt((1 - d) * (1 + d));
      // F is correct to about 1e-15, and its slope at the root is 8·half.
      expect_walk(ball, {0, d, -8}, {0, 0, 1}, {8 - half, 8 + half}, 1e-14 + 1e-14 / half);
    }
    const TracerUnderTest tracer(ball, exact());
    EXPECT_TRUE(tracer.hit(camera_ray({{0, 1 + 1e-12, -8}, {0, 0, 1}})).is_miss());
    for (const double d : {1 - 1e-14, 1 - 1e-15, 1 - 1e-16, 1.0, std::nextafter(1.0, 2.0)}) {
      const render::Hit either = tracer.hit(camera_ray({{0, d, -8}, {0, 0, 1}}));
      EXPECT_TRUE(either.is_miss() || std::abs(either.t - 8) < 1e-6) << either.t;
    }
  }
}

TEST(HardCases, A02_DoubleRootInsideIsNoCrossing) {
  const double middle = 2 * 0.4375 * 0.4375;
  const std::vector<scene::Component> pair = {point({-0.75, 0, 0}, 1), point({0.75, 0, 0}, 1)};
  const auto roots = [&](double threshold) {
    return TracerUnderTest(one_blob(kPovRay, pair, threshold), exact()).walk({-4, 0, 0}, {1, 0, 0});
  };
  EXPECT_THAT(roots(middle), SizeIs(2));
  EXPECT_THAT(roots(middle * (1 - 1e-9)), SizeIs(2));
  const double above = middle * (1 + 1e-9);
  const std::vector<double> four = roots(above);
  ASSERT_THAT(four, SizeIs(4));
  // On the axis F = 2x⁴ + 2.75x² + middle − T.
  const double x = std::sqrt((-2.75 + std::sqrt(2.75 * 2.75 + 8 * (above - middle))) / 4);
  EXPECT_NEAR(four[1], 4 - x, 1e-10);
  EXPECT_NEAR(four[2], 4 + x, 1e-10);
}

TEST(HardCases, A03_QuadrupleRoot) {
  const double c = std::sqrt(1.0 / 3.0);
  const std::vector<scene::Component> pair = {point({-c, 0, 0}, 1), point({c, 0, 0}, 1)};
  const double middle = 8.0 / 9;
  // F = 2x⁴ + 8/9 − T.
  const double x = std::pow(4.0 / 9 * 1e-12, 0.25);
  const std::vector<double> four =
      TracerUnderTest(one_blob(kPovRay, pair, middle * (1 + 1e-12)), exact()).walk({-4, 0, 0}, {1, 0, 0});
  ASSERT_THAT(four, SizeIs(4));
  // F is flat: an error of 1e-16 moves the root by 1e-16/8x³.
  EXPECT_NEAR(four[1], 4 - x, 1e-6);
  EXPECT_NEAR(four[2], 4 + x, 1e-6);
  EXPECT_THAT(TracerUnderTest(one_blob(kPovRay, pair, middle * (1 - 1e-12)), exact()).walk({-4, 0, 0}, {1, 0, 0}),
              SizeIs(2));
}

TEST(HardCases, A08_RootExactlyAtADyadicPlaceIsReportedOnce) {
  for (const double radius : {0.25, 0.5, 0.75}) {
    const double at = (1 - radius * radius) * (1 - radius * radius);
    for (const double threshold : {at, std::nextafter(at, 0.0), std::nextafter(at, 1.0)}) {
      for (const double start : {-2.0, -1.5, -1.0, -1.25}) {
        // F's rounding band, 2⁻⁵²·17·(f + T), over its slope of about 1.
        expect_walk(one_blob(kPovRay, {point({0, 0, 0}, 1)}, threshold), {0, 0, start}, {0, 0, 1},
                    {-radius - start, radius - start}, 1.5e-14);
      }
    }
  }
}

TEST(HardCases, B12_TenThousandCoincidentBlobsAreOneLargerSphere) {
  const int count = 10000;
  const scene::Database many = one_blob(quartic(4), std::vector<scene::Component>(count, point({0, 0, 0}, 1)));
  // count·(1 + 2(1 − q))² = 1
  const double radius = std::sqrt(1 + (1 - 1 / std::sqrt(double{count})) / 2);
  expect_walk(many, {0, 0, -5}, {0, 0, 1}, {5 - radius, 5 + radius}, 1e-12);
}

TEST(HardCases, B17_OppositeCoincidentBlobsAreEmpty) {
  RandomSource random(61);
  std::vector<scene::Component> components;
  for (int i = 0; i < 20; ++i) {
    const Vec3 centre = random.in_ball(1);
    const double radius = random.between(0.1, 0.5);
    components.push_back(point(centre, radius, 3));
    components.push_back(point(centre, radius, -3));
  }
  const TracerUnderTest tracer(one_blob(gaussian(4), components));
  for (int i = 0; i < 1000; ++i) EXPECT_TRUE(tracer.hit(camera_ray(random_line(random, 3, 1))).is_miss());
}

TEST(HardCases, B19_CarvedHoleHasFourRoots) {
  // (3 − 2x²)² − (3 − 8x²)² = 1 while x² < 3/8; beyond, the first sphere alone.
  const double inner = std::sqrt((36 - std::sqrt(36.0 * 36 - 240)) / 120);
  expect_walk(one_blob(quartic(4), {point({0, 0, 0}, 1), point({0, 0, 0}, 0.5, -1)}), {0, 0, -5}, {0, 0, 1},
              {4, 5 - inner, 5 + inner, 6}, 1e-14);
}

TEST(HardCases, B20_NegativeFieldsAloneAreEmpty) {
  const TracerUnderTest tracer(one_blob(gaussian(4), {point({0, 0, 0}, 1, -2), point({0.5, 0, 0}, 1, -1)}));
  RandomSource random(62);
  for (int i = 0; i < 200; ++i) EXPECT_TRUE(tracer.hit(camera_ray(random_line(random, 3, 1))).is_miss());
}

TEST(HardCases, B21_ThresholdNextToTheMaximum) {
  const double below = 1 - 1e-12, radius = std::sqrt(1 - std::sqrt(below));
  const std::vector<scene::Component> ball = {point({0, 0, 0}, 1)};
  // The maximum is flat: the tolerance is F's error of 1e-16 over its slope of 4·7e-7.
  expect_walk(one_blob(kPovRay, ball, below), {0, 0, -5}, {0, 0, 1}, {5 - radius, 5 + radius}, 1e-9);
  for (const double threshold : {1.0, 1 + 1e-12, 2.0}) {
    EXPECT_THAT(TracerUnderTest(one_blob(kPovRay, ball, threshold), exact()).walk({0, 0, -5}, {0, 0, 1}), IsEmpty());
  }
}

TEST(HardCases, B22_TinyThresholdReachesAlmostToTheSupport) {
  const double radius = std::sqrt(1 - std::sqrt(1e-12));
  expect_walk(one_blob(kPovRay, {point({0, 0, 0}, 1)}, 1e-12), {0, 0, -5}, {0, 0, 1}, {5 - radius, 5 + radius}, 1e-14);
}

TEST(HardCases, B24_ChainOfAThousandBlobsHasAllItsRoots) {
  std::vector<scene::Component> chain;
  std::vector<double> expected;
  for (int i = 0; i < 1000; ++i) {
    chain.push_back(point({0, 0, 4.0 * i}, 1));
    expected.insert(expected.end(), {4.0 * i + 9, 4.0 * i + 11});
  }
  expect_walk(one_blob(gaussian(4), chain), {0, 0, -10}, {0, 0, 1}, expected, 1e-9);
}

TEST(HardCases, C32_HardestKernelsAreMetThroughTheirVeryMiddle) {
  // Fields reach e^500 there, and a cauchy is a spike. Three in a row make the ray continue.
  for (const scene::Kernel& kernel :
       {gaussian(500), soft(500), metaball(500), cauchy(60), cauchy(80), cauchy(300), cauchy(500)}) {
    SCOPED_TRACE(testing::Message() << "kernel " << static_cast<int>(kernel.shape) << ", hardness " << kernel.hardness);
    const scene::Database row = one_blob(kernel, {point({0, 0, 0}, 1), point({0, 0, 3}, 1), point({0, 0, 6}, 0.5, 2)});
    // The last component has strength 2, so its surface is where φ = ½.
    const ReferenceKernel phi(kernel);
    long double low = 1, high = phi.support().hi();
    for (int i = 0; i < 70; ++i) (phi.value((low + high) / 2) > 0.5L ? low : high) = (low + high) / 2;
    const double last = 0.5 * static_cast<double>(std::sqrt(low));
    expect_walk(row, {0, 0, -5}, {0, 0, 1}, {4, 6, 7, 9, 11 - last, 11 + last}, 1e-13);
    expect_walk(row, {0, 0, 0}, {0, 0, 1}, {1, 2, 4, 6 - last, 6 + last}, 1e-13);
    expect_walk(row, {0, 0, 3}, {0, 0, -1}, {1, 2, 4}, 1e-13);
  }
}

TEST(HardCases, D37_RayFromInsideLeavesFirst) {
  const TracerUnderTest tracer(one_blob(gaussian(4), {point({0, 0, 0}, 1)}), exact());
  RandomSource random(63);
  for (int i = 0; i < 1000; ++i) {
    const LineOfSight line{random.in_ball(0.95), random.direction()};
    const render::Hit hit = tracer.hit(camera_ray(line));
    const double along = line.origin.dot(line.direction);
    ASSERT_FALSE(hit.is_miss());
    EXPECT_TRUE(hit.from_inside);
    EXPECT_NEAR(hit.t, -along + std::sqrt(along * along + 1 - line.origin.length2()), 1e-13);
    EXPECT_THAT(tracer.walk(line.origin, line.direction), SizeIs(1));
  }
}

TEST(HardCases, D38_RayFromTheSurfaceForgetsWhereItStarts) {
  const TracerUnderTest tracer(one_blob(gaussian(4), {point({0, 0, 0}, 1)}), exact());
  RandomSource random(64);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 start = random.direction(), direction = random.direction();
    const render::Hit hit = tracer.hit({start, direction, kInfinity, 0, {0, 0}});
    const double chord = -2 * start.dot(direction);
    EXPECT_EQ(hit.is_miss(), chord < 0);
    if (!hit.is_miss()) {
      // F is correct to some 1e-15 at both ends, and its slope at the far one is 4·chord.
      EXPECT_NEAR(hit.t, chord, 1e-14 + 2e-15 / chord);
    }
  }
}

TEST(HardCases, D40_ShadowRayThatEndsInsideIsOccluded) {
  // POV-Ray's sphere with its surface at √(1 − √½) = 0.5412: a ray enters at 2.4588 and leaves at 3.5412.
  const TracerUnderTest tracer(one_blob(kPovRay, {point({0, 0, 0}, 1)}, 0.5));
  const auto is_occluded = [&](const Vec3& origin, double t_max) {
    const std::vector<render::Ray> ray = {{origin, {0, 0, 1}, t_max, 0, {}}};
    std::uint8_t occluded = 2;
    tracer.occlude()(ray, {&occluded, 1});
    return int{occluded};
  };
  for (const double before : {1.0, 2.1, 2.458}) EXPECT_EQ(is_occluded({0, 0, -3}, before), 0) << before;
  for (const double beyond : {2.459, 3.0, 3.5, 3.6, 9.0, kInfinity})
    EXPECT_EQ(is_occluded({0, 0, -3}, beyond), 1) << beyond;
  // From inside, only the way out counts.
  EXPECT_EQ(is_occluded({0, 0, 0}, 0.54), 0);
  EXPECT_EQ(is_occluded({0, 0, 0}, 0.55), 1);
}

TEST(HardCases, D41_RaysThatAreNoneMiss) {
  const TracerUnderTest tracer(one_blob(gaussian(4), {point({0, 0, 0}, 1)}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Vec3& direction : {Vec3(0), Vec3(nan, 0, 1), Vec3(0, kInfinity, 0), Vec3(nan)}) {
    EXPECT_TRUE(tracer.hit(camera_ray({{0, 0, -3}, direction})).is_miss());
  }
  for (const Vec3& origin : {Vec3(nan, 0, -3), Vec3(0, 0, -kInfinity), Vec3(kInfinity, nan, 0)}) {
    EXPECT_TRUE(tracer.hit(camera_ray({origin, {0, 0, 1}})).is_miss());
  }
}

TEST(HardCases, E45_NeedlesAreTrianglesToTheEnd) {
  for (const double width : {1e-3, 1e-6, 1e-9}) {
    SCOPED_TRACE(width);
    scene::Database needle = one_blob(quartic(4), {triangle({-1, 0, 0}, {1, 0, 0}, 0.25)});
    needle.blobs[0].corners = {{1, 0, width}};
    expect_walk(needle, {0, -4, width / 4}, {0, 1, 0}, {3.75, 4.25}, 1e-14);
    expect_walk(needle, {-4, 0, 0}, {1, 0, 0}, {2.75, 5.25}, 1e-14);
    // The long edge leans, so from the side it is a little nearer than its height there.
    const double lean = std::sqrt(1 + width * width / 4);
    expect_walk(needle, {0, 0, -4}, {0, 0, 1}, {3.75, 4 + width / 2 + 0.25 * lean}, 1e-14);
  }
}

TEST(HardCases, E46_RingsAreMetAllAround) {
  const scene::Database ring = one_blob(gaussian(4), {circle({0, 0, 0}, {0, 1, 0}, 1, 0.25)});
  expect_walk(ring, {-4, 0, 0}, {1, 0, 0}, {2.75, 3.25, 4.75, 5.25}, 1e-14);
  expect_walk(ring, {1, -4, 0}, {0, 1, 0}, {3.75, 4.25}, 1e-14);
  // Lines along the axis, where the distance has a crease, and next to it.
  for (const double x : {0.0, 1e-300, 1e-17, 1e-9}) expect_walk(ring, {x, -4, 0}, {0, 1, 0}, {}, 0);
  const double inner = std::sqrt(0.5625 - 0.25), outer = std::sqrt(1.5625 - 0.25);
  expect_walk(ring, {-4, 0, 0.5}, {1, 0, 0}, {4 - outer, 4 - inner, 4 + inner, 4 + outer}, 1e-14);
}

TEST(HardCases, E47_BoxesHaveFacesAndRoundEdges) {
  const scene::Database solid = one_blob(soft(4), {box({-1, -0.5, -2}, {1, 0.5, 2}, 0.25)});
  expect_walk(solid, {0.25, 0, -4}, {0, 0, 1}, {1.75, 6.25}, 1e-14);
  // Lines from within, where the field is level.
  expect_walk(solid, {0, 0, 0}, {0, 1, 0}, {0.75}, 1e-14);
  expect_walk(solid, {0.9, -0.4, 1.9}, {0, 0, -1}, {4.15}, 1e-14);
  // Lines along the border of a face and of an edge, and past an edge.
  expect_walk(solid, {1, 0, -4}, {0, 0, 1}, {1.75, 6.25}, 1e-14);
  expect_walk(solid, {1, 0.5, -4}, {0, 0, 1}, {1.75, 6.25}, 1e-14);
  const double x = 1.15 - 1, edge = std::sqrt(0.0625 - x * x);
  expect_walk(solid, {1.15, 0, -4}, {0, 0, 1}, {2 - edge, 6 + edge}, 1e-14);
}

}  // namespace
}  // namespace isl::reference
