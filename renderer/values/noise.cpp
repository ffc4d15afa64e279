#include "renderer/values/noise.h"

#include "renderer/values/integer.h"
#include "renderer/values/lattice_noise.h"
#include "renderer/values/noise_tables.h"

#include <algorithm>
#include <cmath>

namespace isl::values {
namespace {

using scene::Vec3;

/// These bring the sum of the original noise into [0, 1], and Perlin's about its middle. The values are measured.
constexpr double kRangeOffset = 1.05242, kRangeScale = 0.48985582;
constexpr double kPerlinMiddle = 0.4925, kPerlinScale = 0.795;
/// The origin of Perlin's lattice, measured. It is known modulo 2048 and up to the rounding that its size brings;
/// nothing more can be observed from outside.
constexpr double kPerlinOrigin = 8390272 + 0.023157212883234024;

double s_curve(double t) { return t * t * (3 - 2 * t); }

double perlin(const Vec3& p) {
  const NoiseTables& tables = noise_tables();
  constexpr std::uint32_t kMask = NoiseTables::kGradients - 1;
  std::uint32_t cell[3][2];
  double fraction[3], s[3];
  for (int i = 0; i < 3; ++i) {
    const double t = p[i] + kPerlinOrigin, below = std::floor(t);
    const auto number = static_cast<std::uint32_t>(to_integer(below));
    cell[i][0] = number & kMask;
    cell[i][1] = (number + 1) & kMask;
    fraction[i] = std::isfinite(t) ? t - below : 0.0;
    s[i] = s_curve(fraction[i]);
  }
  const auto corner = [&](int x, int y, int z) {
    const std::uint32_t of_xy = tables.permutation[tables.permutation[cell[0][x]] + cell[1][y]];
    const auto& g = tables.gradients[of_xy + cell[2][z]];
    return g[0] * (fraction[0] - x) + g[1] * (fraction[1] - y) + g[2] * (fraction[2] - z);
  };
  const auto along_x = [&](int y, int z) { return std::lerp(corner(0, y, z), corner(1, y, z), s[0]); };
  const auto along_y = [&](int z) { return std::lerp(along_x(0, z), along_x(1, z), s[1]); };
  return std::lerp(along_y(0), along_y(1), s[2]);
}

/// The lattice noise whose sum is `sum`.
double noise_of(double sum, NoiseGenerator generator) {
  const double value = generator == NoiseGenerator::original ? sum + 0.5 : (sum + kRangeOffset) * kRangeScale;
  return std::clamp(value, 0.0, 1.0);
}

}  // namespace

NoiseGenerator noise_generator_of(double number) noexcept {
  const int low_bits = to_integer(number) & 3;
  return static_cast<NoiseGenerator>(low_bits == 0 ? 1 : low_bits);
}

double noise(const Vec3& p, NoiseGenerator generator) noexcept {
  if (generator == NoiseGenerator::perlin) return std::clamp(kPerlinMiddle + kPerlinScale * perlin(p), 0.0, 1.0);
  return noise_of(lattice_sum(p), generator);
}

void noise_octaves(const Vec3& p, double scale, double lambda, NoiseGenerator generator,
                   std::span<double> values) noexcept {
  if (generator == NoiseGenerator::perlin || values.size() == 1) {
    for (double& value : values) {
      value = noise(p * scale, generator);
      scale *= lambda;
    }
    return;
  }
  lattice_octaves(p, scale, lambda, values);
  for (double& value : values) value = noise_of(value, generator);
}

Vec3 vector_noise(const Vec3& p) noexcept { return lattice_vector_sum(p, {.count = 1}); }

Vec3 vector_turbulence(const Vec3& p, const Octaves& octaves) noexcept { return lattice_vector_sum(p, octaves); }

double turbulence(const Vec3& p, const Octaves& octaves, NoiseGenerator generator) noexcept {
  double sum = 0, weight = 1;
  for_octaves(p, octaves, generator, [&](double value) {
    sum += value * weight;
    weight *= octaves.omega;
  });
  return sum;
}

}  // namespace isl::values
