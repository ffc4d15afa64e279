// "No adjustments required": radius, hardness, strength, threshold and scale vary over a thousand scenes, each rendered
// unchanged with the settings that the program ships. No ray falls through a hole, and no step is uncertified.
#include "tests/reference/agreement.h"
#include "tests/reference/random_scenes.h"
#include "tests/reference/small_scenes.h"
#include "tests/reference/tracer_under_test.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <iterator>

namespace isl::reference {
namespace {

/// A random number whose logarithm is uniform.
double decades(RandomSource& random, double low, double high) { return low * std::pow(high / low, random.unit()); }

struct SweptScene {
  scene::Database database;
  double scale;
};

/// A few components of one kernel in a row, so that they blend with their neighbours.
SweptScene swept_scene(std::uint64_t seed) {
  RandomSource random(seed);
  const double scale = decades(random, 1e-6, 1e6), radius = scale * decades(random, 0.003, 0.5);
  constexpr int kKernels = std::size(scene::kKernelWords);
  const int kernel = random.below(kKernels + 1);
  const scene::Kernel used = kernel == kKernels
                                 ? kPovRay
                                 : scene::Kernel{static_cast<scene::KernelShape>(kernel), scene::RadiusMeaning::surface,
                                                 decades(random, 0.25, 100)};
  const double strength = decades(random, 0.1, 10), threshold = strength * decades(random, 0.02, 2);
  std::vector<scene::Component> components;
  scene::Vec3 place = random.in_ball(0.5 * scale);
  for (int i = 1 + random.below(12); i > 0; --i) {
    const scene::Vec3 next = place + random.direction() * (radius * random.between(0.5, 3));
    const double own = radius * random.between(0.5, 1.5);
    const double sign = random.below(5) == 0 ? -1 : 1;
    switch (random.below(4)) {
      case 0: components.push_back(point(place, own, sign * strength)); break;
      case 1: components.push_back(segment(place, next, own, sign * strength)); break;
      case 2: components.push_back(cone(place, own, next, own * random.between(0.3, 1), sign * strength)); break;
      default: {
        scene::Vec3 low = place, high = next;
        for (int axis = 0; axis < 3; ++axis) {
          low[axis] = std::min(place[axis], next[axis]);
          high[axis] = std::max(place[axis], next[axis]);
        }
        components.push_back(box(low, high, own, sign * strength));
      }
    }
    place = next;
  }
  return {one_blob(used, components, threshold), scale};
}

TEST(NoAdjustments, AThousandScenesHaveNoHoleAndNoUncertifiedStep) {
  std::size_t hits = 0, with_surface = 0, excused = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    const auto [database, scale] = swept_scene(seed);
    const ReferenceScene scene(database);
    const TracerUnderTest tracer(database);
    RandomSource random(seed + 1000000);
    const auto& components = database.blobs[0].components;
    std::vector<render::Ray> rays;
    for (int i = 0; i < 24; ++i) {
      // Rays aim towards the components, near and past them.
      const scene::Component& aim =
          components[static_cast<std::size_t>(random.below(static_cast<int>(components.size())))];
      const scene::Vec3 target = aim.a + random.in_ball(1.5 * aim.radius_a), eye = random.direction() * (3 * scale);
      rays.push_back(camera_ray({eye, (target - eye).normalized()}));
    }
    const Agreement first = compare_first_hits(scene, tracer.trace(), rays, tracer.comparison());
    const std::vector<render::Ray> shadows = shadow_rays(tracer, rays, scale, random);
    const Agreement second = compare_occlusions(scene, tracer.occlude(), shadows, tracer.comparison());
    EXPECT_EQ(first.disagreements(), 0U) << "seed " << seed << ": " << first.text();
    EXPECT_EQ(second.disagreements(), 0U) << "seed " << seed << ", shadows: " << second.text();
    EXPECT_EQ(tracer.uncertified_steps(), 0U) << "seed " << seed;
    hits += first.hits;
    with_surface += first.hits > 0 ? 1 : 0;
    excused += first.lost_in_rounding + first.too_thin + second.lost_in_rounding + second.too_thin;
  }
  EXPECT_GT(with_surface, 700U);
  EXPECT_GT(hits, 6000U);
  EXPECT_LT(excused, 50U);
}

}  // namespace
}  // namespace isl::reference
