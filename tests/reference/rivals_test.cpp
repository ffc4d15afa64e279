// The baselines: the certified ones miss nothing that the reference finds, the others miss what their papers say they
// miss, and the search ends for every ray.
#include "tests/reference/agreement.h"
#include "tests/reference/random_scenes.h"
#include "tests/reference/small_scenes.h"
#include "tests/reference/tracer_under_test.h"
#include "tests/support/sphereflake.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

namespace isl::reference {
namespace {

struct Rival {
  const char* name;
  render::SolverName solver;
  bool octree = false;
};

constexpr Rival kCertified[] = {{"interval", render::SolverName::interval},
                                {"lg", render::SolverName::lg},
                                {"lg_octree", render::SolverName::lg, true},
                                {"inclusion", render::SolverName::inclusion}};
constexpr Rival kAll[] = {{"interval", render::SolverName::interval},  {"lg", render::SolverName::lg},
                          {"march", render::SolverName::march},        {"climb", render::SolverName::climb},
                          {"sphere", render::SolverName::sphere},      {"segment", render::SolverName::segment},
                          {"inclusion", render::SolverName::inclusion}};

std::string name_of(const testing::TestParamInfo<Rival>& given) { return given.param.name; }

render::TracerOptions options_of(const Rival& rival, render::Tolerance tolerance, render::Tolerance step = {1, true}) {
  render::TracerOptions options = with(rival.solver, tolerance);
  options.step = step;
  options.octree = rival.octree;
  return options;
}

std::vector<render::Ray> random_rays(RandomSource& random, int count, double distance, double target) {
  std::vector<render::Ray> rays;
  for (int i = 0; i < count; ++i) rays.push_back(camera_ray(random_line(random, distance, target)));
  return rays;
}

class CertifiedRivals : public testing::TestWithParam<Rival> {};

struct RandomBlobsCase {
  const char* name;
  RandomBlobOptions options;
};
constexpr RandomBlobsCase kCases[] = {{"smooth", {.scale = 1, .hardest = 8}},
                                      {"small", {.scale = 1e-3, .hardest = 8}},
                                      {"hard", {.scale = 1, .hardest = 40}},
                                      {"trees", {.scale = 1, .maxima = true, .hardest = 8}},
                                      {"half-spaces", {.scale = 1, .half_space = true, .hardest = 8}},
                                      {"convolved", {.scale = 1, .convolutions = true, .hardest = 8}}};

TEST_P(CertifiedRivals, MissNothingOnRandomBlobs) {
  for (const RandomBlobsCase& given : kCases) {
    RandomSource random(71);
    std::size_t hits = 0, excused = 0, rays_in_all = 0;
    for (const int components : {1, 2, 3, 5, 9, 17, 40, 100}) {
      RandomBlobOptions blob = given.options;
      blob.components = components;
      const scene::Database database = random_blob(random, blob);
      const ReferenceScene scene(database);
      const TracerUnderTest tracer(database, options_of(GetParam(), {1e-6 * blob.scale, false}));
      std::vector<render::Ray> rays = random_rays(random, 60, 3 * blob.scale, 0.7 * blob.scale);
      for (int i = 0; i < 20; ++i) rays.push_back(camera_ray({random.in_ball(0.7 * blob.scale), random.direction()}));
      const Agreement agreement = compare_first_hits(scene, tracer.trace(), rays, tracer.comparison());
      EXPECT_EQ(agreement.disagreements(), 0U) << given.name << ' ' << components << ": " << agreement.text();
      const std::vector<render::Ray> shadows = shadow_rays(tracer, rays, blob.scale, random);
      const Agreement shaded = compare_occlusions(scene, tracer.occlude(), shadows, tracer.comparison());
      EXPECT_EQ(shaded.disagreements(), 0U) << given.name << ' ' << components << ": " << shaded.text();
      hits += agreement.hits;
      excused += agreement.lost_in_rounding + agreement.too_thin + shaded.lost_in_rounding + shaded.too_thin;
      rays_in_all += rays.size() + shadows.size();
    }
    EXPECT_GT(hits, rays_in_all / 20) << given.name;
    EXPECT_LT(excused, rays_in_all / 50) << given.name;
  }
}

TEST_P(CertifiedRivals, MissNothingOnTheSphereflake) {
  const scene::Database database = test::sphereflake(3, gaussian(4));
  const ReferenceScene scene(database);
  const TracerUnderTest tracer(database, options_of(GetParam(), {0.05, true}));
  RandomSource random(72);
  const std::vector<render::Ray> rays = random_rays(random, 1000, 3, 0.9);
  const Agreement agreement = compare_first_hits(scene, tracer.trace(), rays, tracer.comparison());
  std::cout << GetParam().name << ": " << agreement.text() << '\n';
  EXPECT_EQ(agreement.disagreements(), 0U) << agreement.text();
  EXPECT_GT(agreement.hits, 300U);
}

INSTANTIATE_TEST_SUITE_P(Rivals, CertifiedRivals, testing::ValuesIn(kCertified), name_of);

class Rivals : public testing::TestWithParam<Rival> {};

TEST_P(Rivals, FindASphereToTheirTolerance) {
  for (const double radius : {1e-3, 1.0, 1e3}) {
    const scene::Database database = one_blob(gaussian(4), {point({0, 0, 0}, radius)});
    const double tolerance = 1e-5 * radius;
    const TracerUnderTest tracer(database, options_of(GetParam(), {tolerance, false}, {1e-2 * radius, false}));
    RandomSource random(73);
    for (int i = 0; i < 100; ++i) {
      // The line passes within nine tenths of the radius, because near the rim one step may pass over the sphere.
      const LineOfSight line = random_line(random, 3 * radius, 0.9 * radius);
      const double middle = -line.origin.dot(line.direction);
      const double across2 = (line.origin + line.direction * middle).length2();
      if (across2 > 0.81 * radius * radius) continue;
      const double expected = middle - std::sqrt(radius * radius - across2);
      const render::Hit hit = tracer.hit(camera_ray(line));
      ASSERT_FALSE(hit.is_miss()) << radius;
      EXPECT_LE(std::abs(hit.t - expected), tolerance * (1 + 1e-9)) << radius;
      EXPECT_FALSE(hit.from_inside);
    }
  }
}

TEST_P(Rivals, EndWithEveryRay) {
  // Whole lines from hit to hit, from inside as well as outside, through blobs of every kind; and rays that lie in a
  // face, where F is the threshold all along.
  RandomSource random(74);
  for (const RandomBlobsCase& given : kCases) {
    RandomBlobOptions blob = given.options;
    blob.components = 12;
    const scene::Database database = random_blob(random, blob);
    const TracerUnderTest tracer(database, options_of(GetParam(), {0.05, true}));
    for (int i = 0; i < 20; ++i) {
      const LineOfSight line = random_line(random, 3 * blob.scale, 0.7 * blob.scale);
      EXPECT_LT(tracer.walk(line.origin, line.direction, 2000).size(), 2000U) << given.name;
    }
  }
  const scene::Database flat = one_blob(quartic(3), {box({-1, -1, -1}, {1, 1, 1}, 0.5)});
  const TracerUnderTest tracer(flat, options_of(GetParam(), {1e-6, false}, {1e-3, false}));
  for (const double lift : {0.0, 1e-15, -1e-15, 1e-9, -1e-9}) {
    const render::Hit hit = tracer.hit(camera_ray({{0.1, 1.5 + lift, -5}, {0, 0, 1}}));
    EXPECT_TRUE(hit.is_miss() || (hit.t > 3 && hit.t < 7)) << lift;
  }
}

/// Thin limbs on a ball, which steps and tolerances may pass over.
scene::Database bristles() {
  RandomSource random(75);
  std::vector<scene::Component> components = {point({0, 0, 0}, 0.4)};
  for (int i = 0; i < 40; ++i) components.push_back(segment({0, 0, 0}, random.direction(), 0.004));
  return one_blob(quartic(4), components);
}

struct Misses {
  std::size_t coarse, fine, hits;
};
/// The misses among the reference's hits, with two lengths of step or tolerance. Other differences do not count as
/// misses.
Misses misses_of(const render::TracerOptions& coarse, const render::TracerOptions& fine) {
  const scene::Database database = bristles();
  const ReferenceScene scene(database);
  RandomSource random(76);
  const std::vector<render::Ray> rays = random_rays(random, 2000, 3, 1);
  const Truth truth = truth_of(scene, rays);
  const auto missed = [&](const render::TracerOptions& options, std::size_t& hits) {
    const TracerUnderTest tracer(database, options);
    // Surfaces found behind something missed count as misses too.
    const Agreement agreement =
        compare_first_hits(scene, truth, tracer.trace(), rays, {.tolerance = {0.05, false}, .pixel_angle = 1e-3});
    hits = agreement.hits;
    return agreement.missed + agreement.misplaced;
  };
  Misses misses{};
  misses.coarse = missed(coarse, misses.hits);
  misses.fine = missed(fine, misses.hits);
  return misses;
}

void expect_fewer_misses(const char* name, const Misses& misses) {
  std::cout << name << " misses " << misses.coarse << " and " << misses.fine << " of " << misses.hits << '\n';
  EXPECT_GT(misses.coarse, misses.hits / 50) << name;
  EXPECT_LT(misses.fine, misses.coarse / 4) << name;
}

TEST(March, MissesWhatIsThinnerThanAStep) {
  const Rival march{"march", render::SolverName::march};
  expect_fewer_misses("march", misses_of(options_of(march, {1e-5, false}, {0.05, false}),
                                         options_of(march, {1e-5, false}, {0.002, false})));
}

TEST(Climb, MissesHillsThatShareAStep) {
  const Rival climb{"climb", render::SolverName::climb};
  const Misses misses =
      misses_of(options_of(climb, {1e-5, false}, {0.2, false}), options_of(climb, {1e-5, false}, {0.01, false}));
  std::cout << "climb misses " << misses.coarse << " and " << misses.fine << " of " << misses.hits << '\n';
  EXPECT_GT(misses.coarse, 0U);
  EXPECT_LT(misses.fine, misses.coarse);
}

TEST(Sphere, MissesWhatIsThinnerThanTheTolerance) {
  const Rival sphere{"sphere", render::SolverName::sphere};
  expect_fewer_misses("sphere", misses_of(options_of(sphere, {0.02, false}), options_of(sphere, {1e-4, false})));
}

TEST(Sphere, OverRelaxedTakesFewerStepsToTheSameSurface) {
  const scene::Database database = test::sphereflake(3, gaussian(4));
  RandomSource random(77);
  const std::vector<render::Ray> rays = random_rays(random, 1000, 3, 0.9);
  render::TracerOptions options = with(render::SolverName::sphere, {1e-5, false});
  const TracerUnderTest plain(database, options);
  options.relaxation = 1.6;
  const TracerUnderTest relaxed(database, options);
  const std::vector<render::Hit> one = plain.hits(rays), other = relaxed.hits(rays);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ASSERT_EQ(one[i].is_miss(), other[i].is_miss()) << i;
    if (one[i].is_miss()) continue;
    EXPECT_NEAR(one[i].t, other[i].t, 2e-5) << i;
  }
  EXPECT_LT(relaxed.field_evaluations(), plain.field_evaluations() * 9 / 10);
}

TEST(Segment, TakesFewerStepsThanSphereTracing) {
  const scene::Database database = test::sphereflake(3, gaussian(4));
  RandomSource random(78);
  const std::vector<render::Ray> rays = random_rays(random, 1000, 3, 0.9);
  const TracerUnderTest sphere(database, with(render::SolverName::sphere, {1e-5, false}));
  const TracerUnderTest segment(database, with(render::SolverName::segment, {1e-5, false}));
  const std::vector<render::Hit> one = sphere.hits(rays), other = segment.hits(rays);
  // Either may pass over parts thinner than the tolerance.
  int differ = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    differ += one[i].is_miss() != other[i].is_miss() || std::abs(one[i].t - other[i].t) > 2e-5 ? 1 : 0;
  }
  EXPECT_LT(differ, 5);
  EXPECT_LT(segment.field_evaluations(), sphere.field_evaluations());
}

INSTANTIATE_TEST_SUITE_P(All, Rivals, testing::ValuesIn(kAll), name_of);

}  // namespace
}  // namespace isl::reference
