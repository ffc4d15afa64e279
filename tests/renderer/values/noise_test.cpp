#include "renderer/values/noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace isl::values {
namespace {

using scene::Vec3;

constexpr NoiseGenerator kGenerators[] = {NoiseGenerator::original, NoiseGenerator::range_corrected,
                                          NoiseGenerator::perlin};

// The numbers are those that POV-Ray 3.7 prints for f_noise_generator and vturbulence.
TEST(Noise, IsPovraysToTheLastDigit) {
  const Vec3 p(0.3, -20.2, 7.1);
  EXPECT_NEAR(noise(p, NoiseGenerator::original), 0.361400873958, 1e-12);
  EXPECT_NEAR(noise(p, NoiseGenerator::range_corrected), 0.447640473546, 1e-12);
  EXPECT_NEAR(noise(p, NoiseGenerator::perlin), 0.546256813609, 1e-12);
  const Vec3 v = vector_turbulence({0.1, 0.2, 0.3}, {.lambda = 2, .omega = 0.5, .count = 6});
  EXPECT_NEAR(v.x, -0.0491923917, 1e-10);
  EXPECT_NEAR(v.y, -0.2071783272, 1e-10);
  EXPECT_NEAR(v.z, -0.5548751615, 1e-10);
}

TEST(Noise, IsContinuousAcrossTheLattice) {
  for (const NoiseGenerator generator : kGenerators) {
    for (int i = -3; i <= 3; ++i) {
      const double below = noise({i - 1e-9, 0.4, 0.7}, generator), above = noise({i + 1e-9, 0.4, 0.7}, generator);
      EXPECT_NEAR(below, above, 1e-7);
    }
  }
}

TEST(Noise, StaysWithinZeroAndOneWhateverThePoint) {
  constexpr double kExtremes[] = {0,
                                  -0.0,
                                  1e9,
                                  -1e9,
                                  1e300,
                                  -1e300,
                                  std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::quiet_NaN()};
  for (const NoiseGenerator generator : kGenerators) {
    for (const double x : kExtremes) {
      for (const double y : kExtremes) {
        const double value = noise({x, y, 0.5}, generator);
        EXPECT_TRUE(value >= 0 && value <= 1) << x << ", " << y << ": " << value;
      }
    }
  }
}

TEST(Noise, GeneratorsAreNumberedByTwoBits) {
  EXPECT_EQ(noise_generator_of(0), NoiseGenerator::original);
  EXPECT_EQ(noise_generator_of(1.9), NoiseGenerator::original);
  EXPECT_EQ(noise_generator_of(2), NoiseGenerator::range_corrected);
  EXPECT_EQ(noise_generator_of(3), NoiseGenerator::perlin);
  EXPECT_EQ(noise_generator_of(4), NoiseGenerator::original);
  EXPECT_EQ(noise_generator_of(-1), NoiseGenerator::perlin);
}

TEST(Noise, TurbulenceSumsOctaves) {
  const Vec3 p(0.1, 0.2, 0.3);
  const auto generator = NoiseGenerator::range_corrected;
  const double expected = noise(p, generator) + 0.25 * noise(p * 3, generator);
  EXPECT_DOUBLE_EQ(turbulence(p, {.lambda = 3, .omega = 0.25, .count = 2}, generator), expected);
}

}  // namespace
}  // namespace isl::values
