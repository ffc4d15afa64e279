// What the hardest rays take with each solver.
//
//   hardest_rays [FIRST_SEED [RAYS [STEPS]]]   (1, 10000, the bound of a ray)
//
// Each solver gets the same rays, ten at each blob. A line tells how many of them met the bound, the most steps and
// evaluations of a field that one took, and the longest time of one. Exit code 1 if a ray takes more than it may.
#include "tests/reference/hardest_blob.h"
#include "tests/reference/tracer_under_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace isl::reference {
namespace {

struct Most {
  std::uint64_t rays = 0, spent = 0, steps = 0, evaluations = 0;
  double milliseconds = 0, seconds = 0;
};

Most trace_hardest(const render::NamedSolver& solver, std::uint64_t seed, std::uint64_t rays, std::uint64_t bound) {
  using Clock = std::chrono::steady_clock;
  constexpr int kRaysOfBlob = 10;
  RandomSource random(seed);
  Most most;
  const auto begin = Clock::now();
  for (std::uint64_t i = 0; most.rays < rays; ++i) {
    const scene::Database database = hardest_blob(random, i);
    render::TracerOptions options;
    options.solver = solver.name;
    options.run.steps_of_ray = bound;
    const TracerUnderTest tracer(database, options);
    std::uint64_t before = 0;
    for (const LineOfSight& line : random_lines(random, kRaysOfBlob, 3, 0.7)) {
      const auto start = Clock::now();
      static_cast<void>(tracer.hit(camera_ray(line)));
      const std::chrono::duration<double, std::milli> time = Clock::now() - start;
      most.milliseconds = std::max(most.milliseconds, time.count());
      most.evaluations = std::max(most.evaluations, tracer.field_evaluations() - before);
      before = tracer.field_evaluations();
    }
    most.rays += kRaysOfBlob;
    most.steps = std::max(most.steps, tracer.most_ray_steps());
    most.spent += tracer.spent_rays();
  }
  most.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return most;
}

int trace_with_each(std::uint64_t seed, std::uint64_t rays, std::uint64_t bound) {
  bool is_bounded = true;
  fmt::print("{:12}{:>8}{:>10}{:>12}{:>13}{:>12}{:>8}\n", "solver", "rays", "at bound", "most steps", "evaluations",
             "longest, ms", "all, s");
  for (const render::NamedSolver& solver : render::kSolvers) {
    const Most most = trace_hardest(solver, seed, rays, bound);
    fmt::print("{:12}{:>8}{:>10}{:>12}{:>13}{:>12.2f}{:>8.1f}\n", solver.word, most.rays, most.spent, most.steps,
               most.evaluations, most.milliseconds, most.seconds);
    std::fflush(stdout);
    is_bounded = is_bounded && most.steps <= bound && most.evaluations <= bound + kEvaluationsBeyondBound;
  }
  return is_bounded ? 0 : 1;
}

}  // namespace
}  // namespace isl::reference

int main(int argc, char** argv) {
  const auto number = [&](int i, std::uint64_t otherwise) {
    return i < argc ? std::strtoull(argv[i], nullptr, 10) : otherwise;
  };
  return isl::reference::trace_with_each(number(1, 1), number(2, 10000), number(3, isl::kStepsOfRay));
}
