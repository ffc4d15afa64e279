// The tracer against the reference over whole scenes: the sphereflake, random blobs of every kind at all scales, placed
// blobs, and shadow rays from the surfaces that were found.
#include "tests/reference/agreement.h"

#include "tests/reference/random_scenes.h"
#include "tests/reference/small_scenes.h"
#include "tests/reference/soak_case.h"
#include "tests/reference/tracer_under_test.h"
#include "tests/support/sphereflake.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

namespace isl::reference {
namespace {

constexpr render::Tolerance kShipped{0.05, true};
constexpr render::Tolerance kFine{1e-9, false};

std::vector<render::Ray> random_rays(std::uint64_t seed, int count, double distance, double target) {
  RandomSource random(seed);
  return camera_rays(random_lines(random, count, distance, target));
}

/// Σ 9^k = 7,381 components; with POV-Ray's radii, the threshold leaves its spheres three quarters of their size.
scene::Database flake(const scene::Kernel& kernel) {
  scene::Database database = test::sphereflake(4, kernel);
  if (kernel.meaning == scene::RadiusMeaning::support) database.blobs[0].threshold = 0.2;
  return database;
}

struct FlakeCase {
  const char* name;
  scene::Kernel kernel;
};

class Flake : public testing::TestWithParam<FlakeCase> {};

TEST_P(Flake, TracerAgreesOnTenThousandRays) {
  const scene::Database database = flake(GetParam().kernel);
  const ReferenceScene scene(database);
  const std::vector<render::Ray> rays = random_rays(31, 10000, 3, 0.9);
  const Truth truth = truth_of(scene, rays);
  for (const render::Tolerance tolerance : {kShipped, kFine}) {
    const TracerUnderTest tracer(database, with(render::SolverName::hermite, tolerance));
    const Agreement agreement = compare_first_hits(scene, truth, tracer.trace(), rays, tracer.comparison());
    std::cout << GetParam().name << (tolerance.in_pixels ? " 0.05px: " : " 1e-9: ") << agreement.text() << '\n';
    EXPECT_EQ(agreement.disagreements(), 0U) << agreement.text();
    EXPECT_GT(agreement.hits, 3000U);
    EXPECT_LT(agreement.hits, 9500U);
    EXPECT_LT(agreement.lost_in_rounding + agreement.too_thin, 10U) << agreement.text();
  }
}

TEST_P(Flake, ShadowRaysFromFoundSurfacesAgree) {
  const scene::Database database = flake(GetParam().kernel);
  const ReferenceScene scene(database);
  const TracerUnderTest tracer(database);
  RandomSource random(33);
  const std::vector<render::Ray> shadows = shadow_rays(tracer, random_rays(32, 2000, 3, 0.9), 1, random);
  const Agreement agreement = compare_occlusions(scene, tracer.occlude(), shadows, tracer.comparison());
  std::cout << GetParam().name << ": " << agreement.text() << '\n';
  EXPECT_EQ(agreement.disagreements(), 0U) << agreement.text();
  EXPECT_GT(agreement.hits, shadows.size() / 10);
  EXPECT_LT(agreement.hits, shadows.size() * 9 / 10);
  EXPECT_LT(agreement.lost_in_rounding + agreement.too_thin, shadows.size() / 200) << agreement.text();
}

INSTANTIATE_TEST_SUITE_P(Kernels, Flake,
                         testing::Values(FlakeCase{"gaussian", gaussian(4)}, FlakeCase{"quartic", quartic(4)},
                                         FlakeCase{"povray", kPovRay}),
                         [](const auto& given) { return std::string(given.param.name); });

TEST(FlakeByThePaper, DiffersFromTheReference) {
  // Two interpolants over a field's whole interval, without certification: the front poles are too far out, and some
  // rays meet surfaces that do not exist. This shows that the comparison would see such errors in the product.
  const scene::Database database = flake(gaussian(4));
  const ReferenceScene scene(database);
  const TracerUnderTest tracer(database, with(render::SolverName::paper, kShipped));
  const Agreement agreement =
      compare_first_hits(scene, tracer.trace(), random_rays(31, 2000, 3, 0.9), tracer.comparison());
  std::cout << "paper: " << agreement.text() << '\n';
  EXPECT_GT(agreement.disagreements(), 0U);
}

struct RandomBlobsCase {
  double scale;
  double hardest;
  bool maxima = false;
  bool half_space = false;
  bool convolutions = false;
};

RandomBlobOptions options_of(const RandomBlobsCase& given, int components) {
  return {.components = components,
          .scale = given.scale,
          .maxima = given.maxima,
          .half_space = given.half_space,
          .convolutions = given.convolutions,
          .hardest = given.hardest};
}

class RandomBlobs : public testing::TestWithParam<RandomBlobsCase> {};

TEST_P(RandomBlobs, TracerAgreesOnFirstHitsAndShadows) {
  const double scale = GetParam().scale;
  RandomSource random(41);
  std::size_t hits = 0, excused = 0, rays_in_all = 0;
  for (const int components : {1, 2, 3, 5, 9, 17, 30, 60, 120, 200}) {
    for (int repeat = 0; repeat < 3; ++repeat) {
      const scene::Database database = random_blob(random, options_of(GetParam(), components));
      const ReferenceScene scene(database);
      const TracerUnderTest tracer(database, with(render::SolverName::hermite, {1e-9 * scale, false}));
      std::vector<render::Ray> rays = camera_rays(random_lines(random, 104, 3 * scale, 0.7 * scale));
      // These rays start within the scene, inside or outside the surface at random.
      for (int i = 0; i < 30; ++i) rays.push_back(camera_ray({random.in_ball(0.7 * scale), random.direction()}));
      const Agreement agreement = compare_first_hits(scene, tracer.trace(), rays, tracer.comparison());
      EXPECT_EQ(agreement.disagreements(), 0U)
          << components << " components, repeat " << repeat << ": " << agreement.text();
      for (render::Ray& ray : rays) ray.t_max = random.between(0, 4) * scale;
      const Agreement shadows = compare_occlusions(scene, tracer.occlude(), rays, tracer.comparison());
      EXPECT_EQ(shadows.disagreements(), 0U)
          << components << " components, repeat " << repeat << ": " << shadows.text();
      hits += agreement.hits;
      excused += agreement.lost_in_rounding + agreement.too_thin + shadows.lost_in_rounding + shadows.too_thin;
      rays_in_all += rays.size();
    }
  }
  EXPECT_GT(hits, rays_in_all / 10);
  EXPECT_LT(excused, 5U);
}

/// Every crossing is placed by the extended numbers that otherwise decide what double precision leaves open.
TEST_P(RandomBlobs, ExtendedNumbersAgree) {
  const double scale = GetParam().scale;
  RandomSource random(44);
  std::size_t hits = 0;
  for (const int components : {1, 4, 12, 40}) {
    const scene::Database database = random_blob(random, options_of(GetParam(), components));
    const ReferenceScene scene(database);
    render::TracerOptions options = with(render::SolverName::hermite, {1e-9 * scale, false});
    options.packets = false;
    options.digits = true;
    const TracerUnderTest tracer(database, options);
    const std::vector<render::Ray> rays = camera_rays(random_lines(random, 100, 3 * scale, 0.7 * scale));
    const Agreement agreement = compare_first_hits(scene, tracer.trace(), rays, tracer.comparison());
    EXPECT_EQ(agreement.disagreements(), 0U) << components << " components: " << agreement.text();
    hits += agreement.hits;
  }
  EXPECT_GT(hits, 40U);
}

TEST_P(RandomBlobs, ShadowRaysFromFoundSurfacesAgree) {
  const double scale = GetParam().scale;
  RandomSource random(43);
  std::size_t excused = 0, rays_in_all = 0;
  for (const int components : {1, 4, 12, 40, 120}) {
    const scene::Database database = random_blob(random, options_of(GetParam(), components));
    const ReferenceScene scene(database);
    const TracerUnderTest tracer(database, with(render::SolverName::hermite, {1e-9 * scale, false}));
    const std::vector<render::Ray> eyes = camera_rays(random_lines(random, 120, 3 * scale, 0.7 * scale));
    const std::vector<render::Ray> shadows = shadow_rays(tracer, eyes, scale, random);
    const Agreement agreement = compare_occlusions(scene, tracer.occlude(), shadows, tracer.comparison());
    EXPECT_EQ(agreement.disagreements(), 0U) << components << " components: " << agreement.text();
    excused += agreement.lost_in_rounding + agreement.too_thin;
    rays_in_all += shadows.size();
  }
  EXPECT_GT(rays_in_all, 200U);
  EXPECT_LT(excused, rays_in_all / 50);
}

INSTANTIATE_TEST_SUITE_P(Scales, RandomBlobs,
                         testing::Values(RandomBlobsCase{1e-3, 8}, RandomBlobsCase{0.02, 8}, RandomBlobsCase{1, 8},
                                         RandomBlobsCase{30, 8}, RandomBlobsCase{1e3, 8}));

// A field's middle can be e^40 and more. The rounding lost there must not be charged to the surface.
INSTANTIATE_TEST_SUITE_P(HardKernels, RandomBlobs, testing::Values(RandomBlobsCase{1, 40}, RandomBlobsCase{1, 300}));

INSTANTIATE_TEST_SUITE_P(Trees, RandomBlobs,
                         testing::Values(RandomBlobsCase{1, 8, true}, RandomBlobsCase{0.02, 40, true}));
INSTANTIATE_TEST_SUITE_P(HalfSpaces, RandomBlobs,
                         testing::Values(RandomBlobsCase{1, 8, false, true}, RandomBlobsCase{30, 8, false, true}));
INSTANTIATE_TEST_SUITE_P(TreesWithHalfSpaces, RandomBlobs,
                         testing::Values(RandomBlobsCase{1, 8, true, true}, RandomBlobsCase{1e-3, 8, true, true}));

INSTANTIATE_TEST_SUITE_P(Convolutions, RandomBlobs,
                         testing::Values(RandomBlobsCase{1, 8, false, false, true},
                                         RandomBlobsCase{1e-3, 40, false, true, true},
                                         RandomBlobsCase{30, 300, true, true, true}));

// Blobs of the long proofs that were wrong once, or flagged without need.

TEST(OnceWrong, MaximaWhoseSumsAreLostInTheRoundingOfDoublePrecision) {
  for (const std::uint64_t seed : {507671U, 509508U, 900589U}) {
    RandomSource random(seed);
    const SoakCase made = soak_case(random);
    const ReferenceScene scene(made.database);
    const TracerUnderTest tracer(made.database, with(render::SolverName::hermite, made.tolerance));
    const Agreement first = compare_first_hits(scene, tracer.trace(), made.rays, tracer.comparison());
    EXPECT_EQ(first.disagreements() + first.flagged, 0U) << seed << ": " << first.text();
    const std::vector<render::Ray> shadows = shadow_rays(tracer, made.rays, made.scale, random);
    const Agreement second = compare_occlusions(scene, tracer.occlude(), shadows, tracer.comparison());
    EXPECT_EQ(second.disagreements() + second.flagged, 0U) << seed << ": " << second.text();
  }
}

TEST(OnceFlagged, SumsOfAMaximumThatLeaveTheSurfaceTogetherAndMiddlesOfHardCores) {
  for (const std::uint64_t seed : {701770U, 702112U, 701282U, 808868U, 801972U, 807198U, 803600U, 803732U, 808572U}) {
    RandomSource random(seed);
    const LinesThroughBlob made = lines_through_blob(random, 100);
    const ReferenceScene scene(made.database);
    const TracerUnderTest tracer(made.database);
    const Agreement agreement = compare_first_hits(scene, tracer.trace(), camera_rays(made.lines), tracer.comparison());
    EXPECT_EQ(agreement.disagreements() + agreement.flagged, 0U) << seed << ": " << agreement.text();
  }
}

TEST(PlacedBlobs, TracerAgreesThroughTransformsAndGroups) {
  RandomSource random(51);
  for (int repeat = 0; repeat < 5; ++repeat) {
    scene::Database database = random_blob(random, {.components = 30});
    const scene::Object blob = database.objects.front();
    database.objects.clear();
    for (int copy = 0; copy < 3; ++copy) {
      scene::Object placed = blob;
      placed.parent_from_object = random_transform(random, 1);
      database.groups.push_back({.children = {placed}});
      scene::Object group;
      group.kind = scene::Object::Kind::group;
      group.shape = static_cast<std::uint32_t>(copy);
      group.parent_from_object = random_transform(random, 1);
      database.objects.push_back(group);
    }
    const ReferenceScene scene(database);
    const TracerUnderTest tracer(database, with(render::SolverName::hermite, kFine));
    const std::vector<render::Ray> rays = camera_rays(random_lines(random, 300, 6, 1));
    const Agreement agreement = compare_first_hits(scene, tracer.trace(), rays, tracer.comparison());
    EXPECT_EQ(agreement.disagreements(), 0U) << agreement.text();
    EXPECT_GT(agreement.hits, 20U);
  }
}

}  // namespace
}  // namespace isl::reference
