// Every solver ends for every ray within its bound of steps: hardnesses at both ends of what is allowed, strengths that
// cancel, and maps of condition 10⁸.
#include "tests/reference/random_scenes.h"
#include "tests/reference/tracer_under_test.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <iterator>
#include <vector>

namespace isl::reference {
namespace {

constexpr double kHardest[] = {500, 343, 1e-12, 1e-170, 1e-300};

scene::TransformId stretched(RandomSource& random, scene::Database& database) {
  scene::Transform scaling;
  scaling.matrix.setScale(scene::Vec3(1e4, 1, 1e-4));
  scaling.inverse.setScale(scene::Vec3(1e-4, 1, 1e4));
  database.transforms.push_back(then(scaling, random_transform(random, 0.2)));
  return static_cast<scene::TransformId>(database.transforms.size() - 1);
}

/// Eight components of one hardness; half of them carve what the other half adds, to a part in 10⁹.
scene::Database hardest_blob(RandomSource& random, double hardness) {
  scene::Database database = random_blob(
      random, {.components = 4, .negatives = false, .transforms = false, .half_space = random.below(2) == 0});
  for (scene::Kernel& kernel : database.kernels) {
    if (kernel.meaning == scene::RadiusMeaning::surface) kernel.hardness = hardness;
  }
  scene::Blob& blob = database.blobs.front();
  for (std::size_t i = 0, n = blob.components.size(); i < n; ++i) {
    if (random.below(3) == 0) blob.components[i].transform = stretched(random, database);
    scene::Component carving = blob.components[i];
    carving.strength *= -(1 - 1e-9);
    blob.components.push_back(carving);
    blob.origins.push_back({});
  }
  return database;
}

class EverySolver : public testing::TestWithParam<render::NamedSolver> {};

TEST_P(EverySolver, EndsWithinTheBoundOfARay) {
  // So small that most of these rays meet it.
  constexpr std::uint64_t kBound = std::uint64_t{1} << 14;
  // Nodes at the ends of cells, polished roots and what a spent ray still looks at are not counted: a ray meets some
  // hundred cells, and takes at most some hundred evaluations of ten fields in each.
  constexpr std::uint64_t kCeiling = kBound + 1'000'000;
  constexpr int kBlobs = 30, kRays = 10;
  RandomSource random(50);
  std::uint64_t spent = 0;
  for (int i = 0; i < kBlobs; ++i) {
    const scene::Database database = hardest_blob(random, kHardest[static_cast<std::size_t>(i) % std::size(kHardest)]);
    render::TracerOptions options;
    options.solver = GetParam().name;
    options.run.steps_of_ray = kBound;
    const TracerUnderTest tracer(database, options);
    std::uint64_t before = 0;
    for (const LineOfSight& line : random_lines(random, kRays, 3, 0.7)) {
      static_cast<void>(tracer.hit(camera_ray(line)));
      EXPECT_LE(tracer.field_evaluations() - before, kCeiling) << GetParam().word << ", blob " << i;
      before = tracer.field_evaluations();
    }
    EXPECT_LE(tracer.most_ray_steps(), kBound);
    spent += tracer.spent_rays();
  }
  // Otherwise these rays are not hard.
  if (GetParam().name == render::SolverName::exact) {
    EXPECT_GT(spent, 0U);
  }
}

INSTANTIATE_TEST_SUITE_P(Solvers, EverySolver, testing::ValuesIn(render::kSolvers),
                         [](const testing::TestParamInfo<render::NamedSolver>& given) {
                           return std::string(given.param.word);
                         });

/// The bound decides nothing but where the search ends.
TEST(RayBound, LeavesARayThatTakesFewerSteps) {
  RandomSource random(51);
  const scene::Database database = random_blob(random, {.components = 20});
  render::TracerOptions bounded;
  bounded.run.steps_of_ray = 1 << 16;
  const TracerUnderTest one(database, bounded), other(database, {});
  std::vector<render::Ray> rays;
  for (const LineOfSight& line : random_lines(random, 1000, 3, 0.7)) rays.push_back(camera_ray(line));
  const std::vector<render::Hit> found = one.hits(rays), again = other.hits(rays);
  for (std::size_t i = 0; i < rays.size(); ++i) EXPECT_EQ(found[i].t, again[i].t) << i;
  EXPECT_EQ(one.spent_rays(), 0U);
}

}  // namespace
}  // namespace isl::reference
