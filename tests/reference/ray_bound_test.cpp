// Every solver ends for every ray within its bound of steps.
#include "tests/reference/hardest_blob.h"
#include "tests/reference/random_scenes.h"
#include "tests/reference/tracer_under_test.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace isl::reference {
namespace {

class EverySolver : public testing::TestWithParam<render::NamedSolver> {};

TEST_P(EverySolver, EndsWithinTheBoundOfARay) {
  // So small that most of these rays meet it.
  constexpr std::uint64_t kBound = std::uint64_t{1} << 14;
  constexpr int kBlobs = 30, kRays = 10;
  RandomSource random(50);
  std::uint64_t spent = 0;
  for (int i = 0; i < kBlobs; ++i) {
    const scene::Database database = hardest_blob(random, static_cast<std::uint64_t>(i));
    render::TracerOptions options;
    options.solver = GetParam().name;
    options.run.steps_of_ray = kBound;
    const TracerUnderTest tracer(database, options);
    std::uint64_t before = 0;
    for (const LineOfSight& line : random_lines(random, kRays, 3, 0.7)) {
      static_cast<void>(tracer.hit(camera_ray(line)));
      EXPECT_LE(tracer.field_evaluations() - before, kBound + kEvaluationsBeyondBound)
          << GetParam().word << ", blob " << i;
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
