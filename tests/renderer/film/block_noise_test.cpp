// Whether pixels tell their noise as it is.
#include "renderer/film/block_noise.h"

#include "renderer/numerics/chance.h"
#include "renderer/numerics/sample_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace isl::render::test {
namespace {

constexpr BlockNoise::Value kRed{1, 0, 0, 0};

using Integrand = std::function<double(std::uint32_t seed, std::uint32_t number)>;

struct Noises {
  double told = 0, real = 0;  ///< roots of mean squares over many pixels
};

/// The noise of `count` samples, the last half of which is told apart, as in a pixel's last pass.
Noises noises(std::uint32_t count, double integral, const Integrand& value) {
  constexpr std::uint32_t kPixels = 3000;
  Noises sum;
  for (std::uint32_t seed = 0; seed < kPixels; ++seed) {
    double first = 0, second = 0;
    BlockNoise block;
    for (std::uint32_t i = 0; i < count; ++i) {
      const double sample = value(seed, i);
      (i < count / 2 ? first : second) += sample;
      if (i >= count / 2) block.add({sample, 0, 0}, 0);
    }
    const std::uint32_t half = count / 2;
    const BlockNoise::Value before{first / half, 0, 0, 0};
    sum.told += block.variance(&before, kRed) / kPixels;
    sum.real += std::pow((first + second) / count - integral, 2) / kPixels;
  }
  return {std::sqrt(sum.told), std::sqrt(sum.real)};
}

double at_random(std::uint32_t seed, std::uint32_t number) { return chance_at(seed, number, 0); }

double below_an_edge(std::uint32_t seed, std::uint32_t number) {
  const UnitPoint point = sample_point(derived_seed(seed, 1), number);
  return point.v < 0.3 + 0.5 * point.u ? 1 : 0;
}

double smooth(std::uint32_t seed, std::uint32_t number) {
  const UnitPoint point = sample_point(derived_seed(seed, 1), number);
  return point.u * point.v;
}

TEST(BlockNoise, is_told_within_a_factor) {
  // The faster the mean converges, the less the few blocks tell how fast, and too much is said of the noise.
  for (const std::uint32_t count : {16U, 64U, 512U}) {
    const Noises random = noises(count, 0.5, at_random);
    EXPECT_NEAR(random.real, std::sqrt(1.0 / 12 / count), 0.05 * random.real);
    EXPECT_GT(random.told, random.real / 1.5) << count;
    EXPECT_LT(random.told, random.real * 1.5) << count;
    const Noises edge = noises(count, 0.55, below_an_edge);
    EXPECT_GT(edge.told, edge.real / 1.5) << count;
    EXPECT_LT(edge.told, edge.real * 2) << count;
    const Noises even = noises(count, 0.25, smooth);
    EXPECT_GT(even.told, even.real) << count;
    EXPECT_LT(even.told, even.real * 3) << count;
  }
}

TEST(BlockNoise, of_equal_samples_is_none) {
  BlockNoise block;
  for (int i = 0; i < 8; ++i) block.add({0.3, 0.2, 0.1}, 1);
  const BlockNoise::Value before{0.3, 0.2, 0.1, 1};
  EXPECT_EQ(block.variance(&before, {1, 1, 1, 1}), 0);
  EXPECT_EQ(block.mean(), before);
}

TEST(BlockNoise, counts_channels_by_their_weights) {
  BlockNoise block;
  for (int i = 0; i < 8; ++i) block.add({i % 3 == 0 ? 1.0 : 0, i % 2 == 0 ? 1.0 : 0, 0}, 0);
  const double red = block.variance(nullptr, {1, 0, 0, 0});
  EXPECT_NEAR(block.variance(nullptr, {2, 0, 0, 0}), 4 * red, 1e-12);
  EXPECT_GT(red, 0);
}

}  // namespace
}  // namespace isl::render::test
