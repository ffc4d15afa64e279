// Compares the tracer with the reference on random blobs of every kind, as many as you like: the comparison of the
// tests with fixed seeds, a million times. Every blob has a seed of its own, which is printed with every disagreement,
// so that it can be repeated.
//
//   soak [FIRST_SEED [RAYS]]      (1, 1000000)
//
// A blob has 1 to 200 components of all skeletons and kernels. Depending on the seed, half of them carve or are mapped,
// and it has maxima, sometimes a half-space (or a sheet), and every other time convolutions, a hardness up to 300, and
// a scale from 10⁻³ to 10³. Half of the rays look for the first hit, and half are shadow rays from the surfaces that
// were found, at all angles down to grazing. Exit code 1 after a disagreement.
#include "tests/reference/agreement.h"
#include "tests/reference/random_scenes.h"
#include "tests/reference/small_scenes.h"
#include "tests/reference/tracer_under_test.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace {

using namespace isl;
using namespace isl::reference;

constexpr double kTolerances[] = {0.05, 1e-6, 1e-10};

struct Totals {
  std::uint64_t rays = 0, hits = 0, excused = 0, wrong = 0, uncertified = 0;
};

RandomBlobOptions options_of(RandomSource& random) {
  RandomBlobOptions options;
  options.components = 1 + static_cast<int>(std::pow(200, random.unit()));
  options.scale = std::pow(10, random.between(-3, 3));
  options.negatives = random.below(2) == 0;
  options.transforms = random.below(2) == 0;
  options.maxima = random.below(3) == 0;
  options.half_space = random.below(6) == 0;
  options.hardest = std::pow(300, random.unit());
  options.convolutions = random.below(2) == 0;
  return options;
}

void judge(const Agreement& agreement, const char* what, std::uint64_t seed, Totals& totals) {
  totals.hits += agreement.hits;
  totals.excused += agreement.lost_in_rounding + agreement.too_thin;
  totals.wrong += agreement.disagreements();
  if (agreement.disagreements() > 0) std::cout << "seed " << seed << ", " << what << ": " << agreement.text() << '\n';
}

void soak_one(std::uint64_t seed, Totals& totals) {
  RandomSource random(seed);
  const RandomBlobOptions options = options_of(random);
  const scene::Database database = random_blob(random, options);
  const ReferenceScene scene(database);
  const int which = random.below(3);
  const render::Tolerance tolerance{which == 0 ? kTolerances[0] : kTolerances[which] * options.scale, which == 0};
  const TracerUnderTest tracer(database, with(render::SolverName::hermite, tolerance));

  constexpr int kEyes = 104, kWithin = 20;
  std::vector<render::Ray> rays = camera_rays(random_lines(random, kEyes, 3 * options.scale, 0.7 * options.scale));
  for (int i = 0; i < kWithin; ++i)
    rays.push_back(camera_ray({random.in_ball(0.7 * options.scale), random.direction()}));
  judge(compare_first_hits(scene, tracer.trace(), rays, tracer.comparison()), "first hits", seed, totals);

  const std::vector<render::Ray> shadows = shadow_rays(tracer, rays, options.scale, random);
  judge(compare_occlusions(scene, tracer.occlude(), shadows, tracer.comparison()), "shadows", seed, totals);
  const std::uint64_t uncertified = tracer.uncertified_steps();
  if (uncertified > 0)
    std::cout << "seed " << seed << ": " << uncertified << " uncertified steps, hardest " << options.hardest << '\n';
  totals.uncertified += uncertified;
  totals.rays += rays.size() + shadows.size();
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t seed = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1;
  const std::uint64_t rays = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1000000;
  const std::uint64_t first = seed;
  Totals totals;
  for (; totals.rays < rays; ++seed) soak_one(seed, totals);
  std::cout << "seeds " << first << " to " << seed - 1 << ": " << totals.rays << " rays, " << totals.hits << " hits, "
            << totals.wrong << " disagreements, " << totals.excused << " lost in rounding, " << totals.uncertified
            << " uncertified steps\n";
  return totals.wrong > 0 ? 1 : 0;
}
