// Hard cases without a closed form: scale, borders, special directions and secondary rays. The reference judges them,
// or a rule that the result must obey.
#include "tests/reference/small_scenes.h"
#include "tests/reference/tracer_under_test.h"

#include <gmock/gmock.h>

#include <cmath>

namespace isl::reference {
namespace {

using scene::Vec3;

void expect_agreement(const scene::Database& database, const std::vector<render::Ray>& rays, double tolerance,
                      std::size_t least_hits) {
  const ReferenceScene scene(database);
  const TracerUnderTest tracer(database, with(render::SolverName::hermite, {tolerance, false}));
  const Agreement agreement = compare_first_hits(scene, tracer.trace(), rays, tracer.comparison());
  EXPECT_EQ(agreement.disagreements(), 0U) << agreement.text();
  EXPECT_GE(agreement.hits, least_hits);
}

TEST(HardCases, B15_SupportsThatExactlyTouch) {
  const scene::Database row =
      one_blob(kPovRay, {point({-1, 0, 0}, 1), point({1, 0, 0}, 1), point({0, 0.5, 0}, 0.5), point({3, 0, 0}, 1)}, 0.3);
  std::vector<render::Ray> rays;
  for (const double y : {0.0, 1e-9, 0.1, 0.25, 0.5, std::nextafter(0.5, 0.0)}) {
    rays.push_back(camera_ray({{-4, y, 0}, {1, 0, 0}}));
    rays.push_back(camera_ray({{6, y, 0}, {-1, 0, 0}}));
    rays.push_back(camera_ray({{0, y, -4}, {0, 0, 1}}));
    rays.push_back(camera_ray({{2, y, -4}, {0, 0, 1}}));
  }
  expect_agreement(row, rays, 1e-10, 12);
}

TEST(HardCases, B16_RayTangentToASupport) {
  // The small sphere is seen through the border of the large one, whose field there is zero.
  const scene::Database pair = one_blob(kPovRay, {point({0, 0, 0}, 1), point({0, 1.2, 0}, 0.5)}, 0.3);
  std::vector<render::Ray> rays;
  for (const double y : {1.0, std::nextafter(1.0, 0.0), std::nextafter(1.0, 2.0), 1 - 1e-12, 1 + 1e-12}) {
    rays.push_back(camera_ray({{0, y, -4}, {0, 0, 1}}));
    rays.push_back(camera_ray({{-4, y, 0}, {1, 0, 0}}));
    rays.push_back(camera_ray({{0, y, 0}, {0, 0, 1}}));
  }
  expect_agreement(pair, rays, 1e-10, rays.size());
  rays.clear();
  for (const double y : {1.0, std::nextafter(1.0, 0.0), std::nextafter(1.0, 2.0)})
    rays.push_back(camera_ray({{y, 0, -4}, {0, 0, 1}}));
  expect_agreement(pair, rays, 1e-10, 0);
}

TEST(HardCases, C26_ScalingByPowersOfTwoIsExact) {
  RandomSource random(71);
  std::size_t hits = 0;
  for (int scene = 0; scene < 10; ++scene) {
    const scene::Database database = random_blob(random, {.components = 15, .transforms = false});
    std::vector<render::Ray> rays;
    for (int i = 0; i < 100; ++i) rays.push_back(camera_ray(random_line(random, 3, 0.6)));
    const TracerUnderTest plain(database);
    const std::vector<render::Hit> expected = plain.hits(rays);
    for (const int k : {-30, -7, -1, 1, 10, 30}) {
      const double factor = std::ldexp(1.0, k);
      const TracerUnderTest large(scaled(database, factor));
      std::vector<render::Ray> moved = rays;
      for (render::Ray& ray : moved) ray.origin *= factor;
      const std::vector<render::Hit> found = large.hits(moved);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(found[i].is_miss(), expected[i].is_miss()) << "scene " << scene << ", 2^" << k << ", ray " << i;
        if (expected[i].is_miss()) continue;
        ++hits;
        ASSERT_EQ(found[i].t, expected[i].t * factor) << "scene " << scene << ", 2^" << k << ", ray " << i;
        ASSERT_EQ(large.surface(moved[i], found[i]).normal, plain.surface(rays[i], expected[i]).normal);
      }
    }
  }
  EXPECT_GT(hits, 500U);
}

TEST(HardCases, C27_TranslationCostsOnlyTheCoordinatesRounding) {
  RandomSource random(72);
  for (const double offset : {0x1p20, 1e6, 1e9}) {
    const Vec3 shift(offset, -offset, offset);
    const scene::Database database = shifted(random_blob(random, {.components = 15, .transforms = false}), shift);
    std::vector<render::Ray> rays;
    for (int i = 0; i < 200; ++i) {
      render::Ray ray = camera_ray(random_line(random, 3, 0.6));
      ray.origin += shift;
      rays.push_back(ray);
    }
    const double ulp = std::nextafter(offset, kInfinity) - offset;
    expect_agreement(database, rays, 4 * ulp, 20);
  }
}

TEST(HardCases, D33_AxisParallelRaysWithZerosOfBothSigns) {
  RandomSource random(73);
  const scene::Database database = random_blob(random, {.components = 40});
  std::vector<render::Ray> rays;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        for (const double zero : {0.0, -0.0}) {
          const Vec3 towards(x == 0 ? zero : x, y == 0 ? zero : y, z == 0 ? zero : z);
          const Vec3 direction = towards / towards.length();
          for (int i = 0; i < 10; ++i) rays.push_back(camera_ray({random.in_ball(0.4) - direction * 3, direction}));
          rays.push_back(camera_ray({direction * -3, direction}));
        }
      }
    }
  }
  expect_agreement(database, rays, 1e-10, rays.size() / 10);
}

TEST(HardCases, D36_RaysPointingAwayAndThroughCornersOfTheBounds) {
  const scene::Database ball = one_blob(kPovRay, {point({0, 0, 0}, 1)}, 0.3);
  RandomSource random(74);
  std::vector<render::Ray> rays;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 at(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    rays.push_back(camera_ray({at * 3, at.normalized()}));         // away from the corner
    rays.push_back(camera_ray({at * 3, (at * -1).normalized()}));  // through the corner to the centre
    const Vec3 across = at.cross(random.direction()).normalized();
    rays.push_back(camera_ray({at - across * 3, across}));  // meets the bounds only at the corner
    rays.push_back(camera_ray({at, across}));               // starts at the corner
    rays.push_back(camera_ray({at, (at * -1).normalized()}));
  }
  expect_agreement(ball, rays, 1e-10, 16);
}

/// Rays that start on a unit sphere made of one component, in directions from grazing to steep.
std::vector<render::Ray> surface_starts(int count, int side) {
  RandomSource random(81);
  std::vector<render::Ray> rays;
  for (int i = 0; i < count; ++i) {
    const Vec3 normal = random.direction(), tangent = normal.cross(random.direction()).normalized();
    const double sine = i % 2 == 0 ? random.between(1e-3, 1) : std::pow(10, random.between(-12, -1));
    const Vec3 direction = (tangent * std::sqrt(1 - sine * sine) + normal * (side * sine)).normalized();
    // Rounding may have turned the flattest directions to the other side.
    if (side * normal.dot(direction) < 0.9e-12) continue;
    rays.push_back({normal, direction, kInfinity, 0, {0, 0}});
  }
  return rays;
}

class SurfaceStarts : public testing::TestWithParam<scene::Kernel> {};

TEST_P(SurfaceStarts, F54_RaysThatLeaveTheSurfaceDoNotMeetIt) {
  const TracerUnderTest tracer(one_blob(GetParam(), {point({0, 0, 0}, 1)}));
  const std::vector<render::Ray> rays = surface_starts(100000, 1);
  EXPECT_GT(rays.size(), 99000U);
  const std::vector<render::Hit> hits = tracer.hits(rays);
  std::vector<std::uint8_t> occluded(rays.size());
  tracer.occlude()(rays, occluded);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ASSERT_TRUE(hits[i].is_miss()) << "n·D = " << rays[i].origin.dot(rays[i].direction) << ", t = " << hits[i].t;
    ASSERT_EQ(occluded[i], 0) << "n·D = " << rays[i].origin.dot(rays[i].direction);
  }
}

TEST_P(SurfaceStarts, F55_RaysThatEnterTheSurfaceAllLeave) {
  const TracerUnderTest tracer(one_blob(GetParam(), {point({0, 0, 0}, 1)}));
  const std::vector<render::Ray> rays = surface_starts(100000, -1);
  const std::vector<render::Hit> hits = tracer.hits(rays);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double chord = -2 * rays[i].origin.dot(rays[i].direction);
    ASSERT_FALSE(hits[i].is_miss()) << "chord " << chord;
    ASSERT_TRUE(hits[i].from_inside) << "chord " << chord;
    // Half a chord of 1e-7 is 1e-15 deep, where F is lost in rounding. The tolerance is the error of F over its slope
    // of 4·chord at the far end.
    ASSERT_NEAR(hits[i].t, chord, 1e-12 + 1e-13 / chord) << "chord " << chord;
  }
}

INSTANTIATE_TEST_SUITE_P(Kernels, SurfaceStarts,
                         testing::Values(gaussian(4), quartic(4), soft(4), metaball(0.2), metaball(4), cauchy(4),
                                         gaussian(60), cauchy(60)));

}  // namespace
}  // namespace isl::reference
