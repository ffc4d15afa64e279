// Spikes thinner than a pixel: a sample rarely meets one, but over many samples it does so as often as the spike's
// share of the area says. (HardCases E52; the paper's sea urchin.)
#include "tests/reference/random_scenes.h"
#include "tests/reference/small_scenes.h"
#include "tests/reference/tracer_under_test.h"

#include <gtest/gtest.h>

#include <cmath>

namespace isl::reference {
namespace {

/// Spikes along y, one in the middle of each of a hundred pixels that lie side by side, seen straight on.
constexpr int kPixels = 100, kSamples = 1024;

class ThinSpikes : public testing::TestWithParam<double> {};

TEST_P(ThinSpikes, AreMetAsOftenAsTheirAreaSays) {
  const double radius = GetParam();  // in pixels
  std::vector<scene::Component> spikes;
  for (int i = 0; i < kPixels; ++i)
    spikes.push_back(segment(scene::Vec3(i + 0.5, -2, 0), scene::Vec3(i + 0.5, 3, 0), radius));
  const scene::Database database = one_blob(quartic(6), spikes);
  const TracerUnderTest tracer(database);
  RandomSource random(52);
  std::size_t met = 0;
  for (int i = 0; i < kPixels; ++i) {
    for (int k = 0; k < kSamples; ++k) {
      const render::Ray ray = camera_ray({{i + random.unit(), random.unit(), -7}, {0, 0, 1}});
      met += tracer.hit(ray).is_miss() ? 0 : 1;
    }
  }
  const double share = 2 * radius, n = double{kPixels} * kSamples;
  const double sigma = std::sqrt(n * share * (1 - share));
  EXPECT_NEAR(static_cast<double>(met), n * share, 4 * sigma);
  // Rays aimed at a spike meet it, even at its edge, from both sides.
  for (int i = 0; i < kPixels; ++i) {
    for (const double offset : {0.0, 0.999999, -0.999999})
      EXPECT_FALSE(tracer.hit(camera_ray({{i + 0.5 + offset * radius, 0.3, -7}, {0, 0, 1}})).is_miss())
          << i << ' ' << offset;
    for (const double offset : {1.000001, -1.000001})
      EXPECT_TRUE(tracer.hit(camera_ray({{i + 0.5 + offset * radius, 0.3, -7}, {0, 0, 1}})).is_miss())
          << i << ' ' << offset;
  }
}

INSTANTIATE_TEST_SUITE_P(Radii, ThinSpikes, testing::Values(0.2, 0.02, 1e-3, 1e-4));

}  // namespace
}  // namespace isl::reference
