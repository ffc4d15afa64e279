#include "renderer/values/noise.h"

#include "renderer/values/integer.h"
#include "renderer/values/noise_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

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

/// The sum of the eight corners' linear functions with the terms from `first` on, as it is defined.
double defined_sum(const Vec3& p, std::size_t first) {
  const NoiseTables& tables = noise_tables();
  constexpr std::uint32_t kMask = NoiseTables::kHashes - 1;
  std::uint32_t cell[3];
  double fraction[3], share[3];
  for (int i = 0; i < 3; ++i) {
    cell[i] = static_cast<std::uint32_t>(to_integer(std::floor(p[i]))) + 10000u;
    fraction[i] = p[i] - std::floor(p[i]);
    share[i] = fraction[i] * fraction[i] * (3 - 2 * fraction[i]);
  }
  double sum = 0;
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    const std::uint32_t d[3] = {corner & 1u, corner >> 1 & 1u, corner >> 2};
    std::uint32_t hash = 0;
    double weight = 1;
    for (int i = 0; i < 3; ++i) {
      hash = tables.hash[hash ^ ((cell[i] + d[i]) & kMask)];
      weight *= d[i] != 0 ? share[i] : 1 - share[i];
    }
    const double* const terms = &tables.terms[hash % NoiseTables::kSlopes + first];
    sum += weight * (terms[0] * 0.5 + terms[1] * (fraction[0] - d[0]) + terms[2] * (fraction[1] - d[1]) +
                     terms[3] * (fraction[2] - d[2]));
  }
  return sum;
}

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

TEST(Noise, HasTheDigitsOfItsDefinition) {
  std::mt19937_64 random(7);
  const auto point = [&](int turn) {
    std::uniform_real_distribution<double> uniform(-1, 1);
    const double size = std::ldexp(1.0, turn % 64 - 8);  // up to beyond 2⁵¹, where all numbers are integers
    Vec3 p(uniform(random) * size, uniform(random) * size, uniform(random) * size);
    if (turn % 7 == 0) p.x = std::floor(p.x);
    if (turn % 11 == 0) p.y = -0.0;
    return p;
  };
  for (int turn = 0; turn < 20000; ++turn) {
    const Vec3 p = point(turn);
    const double corrected = std::clamp((defined_sum(p, 0) + 1.05242) * 0.48985582, 0.0, 1.0);
    ASSERT_EQ(bits(noise(p, NoiseGenerator::range_corrected)), bits(corrected));
    ASSERT_EQ(bits(noise(p, NoiseGenerator::original)), bits(std::clamp(defined_sum(p, 0) + 0.5, 0.0, 1.0)));
    const Vec3 v = vector_noise(p);
    for (int i = 0; i < 3; ++i) ASSERT_EQ(bits(v[i]), bits(defined_sum(p, 4 * static_cast<std::size_t>(i))));
  }
}

TEST(Noise, OctavesComeInTheirOrder) {
  const Vec3 p(0.1, -3.2, 40.3);
  for (int count = 1; count <= 10; ++count) {
    std::vector<double> values;
    for_octaves(p, {.lambda = 3, .omega = 0.25, .count = count}, NoiseGenerator::range_corrected,
                [&](double value) { values.push_back(value); });
    ASSERT_EQ(values.size(), static_cast<std::size_t>(count));
    double scale = 1;
    for (const double value : values) {
      EXPECT_EQ(value, noise(p * scale, NoiseGenerator::range_corrected));
      scale *= 3;
    }
  }
}

}  // namespace
}  // namespace isl::values
