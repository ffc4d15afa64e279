#include "tests/reference/soak_case.h"

#include "tests/reference/tracer_under_test.h"

#include <cmath>
#include <utility>

namespace isl::reference {

RandomBlobOptions varied_options(RandomSource& random) {
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

SoakCase soak_case(RandomSource& random) {
  constexpr double kTolerances[] = {0.05, 1e-6, 1e-10};
  constexpr int kEyes = 104, kWithin = 20;
  const RandomBlobOptions options = varied_options(random);
  SoakCase made{random_blob(random, options), options.scale, {}, {}};
  const int which = random.below(3);
  made.tolerance = {which == 0 ? kTolerances[0] : kTolerances[which] * options.scale, which == 0};
  made.rays = camera_rays(random_lines(random, kEyes, 3 * options.scale, 0.7 * options.scale));
  for (int i = 0; i < kWithin; ++i)
    made.rays.push_back(camera_ray({random.in_ball(0.7 * options.scale), random.direction()}));
  return made;
}

LinesThroughBlob lines_through_blob(RandomSource& random, int lines) {
  const RandomBlobOptions options = varied_options(random);
  scene::Database database = random_blob(random, options);
  return {std::move(database), random_lines(random, lines, 3 * options.scale, 0.7 * options.scale), options.hardest};
}

}  // namespace isl::reference
