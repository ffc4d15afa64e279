#include "renderer/values/noise.h"

#include "renderer/values/integer.h"
#include "renderer/values/noise_tables.h"

#include <algorithm>
#include <cmath>

namespace isl::values {
namespace {

using scene::Vec3;

/// Origin of the lattice coordinates, so that those of usual scenes are positive.
constexpr std::uint32_t kLatticeOrigin = 10000;
/// These bring the sum of the original noise into [0, 1], and Perlin's about its middle. The values are measured.
constexpr double kRangeOffset = 1.05242, kRangeScale = 0.48985582;
constexpr double kPerlinMiddle = 0.4925, kPerlinScale = 0.795;
/// The origin of Perlin's lattice, measured. It is known modulo 2048 and up to the rounding that its size brings;
/// nothing more can be observed from outside.
constexpr double kPerlinOrigin = 8390272 + 0.023157212883234024;

double s_curve(double t) { return t * t * (3 - 2 * t); }

struct Corner {
  double weight;
  const double* terms;  ///< a value and a slope, perhaps more than once
  double x, y, z;       ///< from the corner to the point

  /// The linear function whose coefficients are the terms from `first` on.
  [[nodiscard]] double at(std::size_t first) const {
    return weight * (terms[first] * 0.5 + terms[first + 1] * x + terms[first + 2] * y + terms[first + 3] * z);
  }
};

/// Calls `add` with the eight corners of the lattice cell around p.
template <class Add>
void for_corners(const Vec3& p, Add add) {
  const NoiseTables& tables = noise_tables();
  constexpr std::uint32_t kMask = NoiseTables::kHashes - 1;
  double fraction[3], far_weight[3];
  std::uint32_t cell[3];
  for (int i = 0; i < 3; ++i) {
    const double below = std::floor(p[i]);
    cell[i] = static_cast<std::uint32_t>(to_integer(below)) + kLatticeOrigin;
    fraction[i] = std::isfinite(p[i]) ? p[i] - below : 0.0;
    far_weight[i] = s_curve(fraction[i]);
  }
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    const std::uint32_t dx = corner & 1u, dy = corner >> 1 & 1u, dz = corner >> 2;
    const std::uint32_t of_x = tables.hash[(cell[0] + dx) & kMask];
    const std::uint32_t of_xy = tables.hash[of_x ^ ((cell[1] + dy) & kMask)];
    const std::uint32_t of_xyz = tables.hash[of_xy ^ ((cell[2] + dz) & kMask)];
    const double weight = (dx != 0 ? far_weight[0] : 1 - far_weight[0]) *
                          (dy != 0 ? far_weight[1] : 1 - far_weight[1]) * (dz != 0 ? far_weight[2] : 1 - far_weight[2]);
    add(Corner{weight, &tables.terms[of_xyz % NoiseTables::kSlopes], fraction[0] - dx, fraction[1] - dy,
               fraction[2] - dz});
  }
}

double lattice_sum(const Vec3& p) {
  double sum = 0;
  for_corners(p, [&](const Corner& corner) { sum += corner.at(0); });
  return sum;
}

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

/// Σ omegaⁱ · f(lambdaⁱ · p).
template <class Result, class Function>
Result sum_octaves(const Vec3& p, const Octaves& octaves, Function function) {
  Result sum = function(p);
  double scale = 1, weight = 1;
  for (int i = 1; i < octaves.count; ++i) {
    scale *= octaves.lambda;
    weight *= octaves.omega;
    sum += function(p * scale) * weight;
  }
  return sum;
}

}  // namespace

NoiseGenerator noise_generator_of(double number) noexcept {
  const int low_bits = to_integer(number) & 3;
  return static_cast<NoiseGenerator>(low_bits == 0 ? 1 : low_bits);
}

double noise(const Vec3& p, NoiseGenerator generator) noexcept {
  double value = 0;
  switch (generator) {
    case NoiseGenerator::original: value = lattice_sum(p) + 0.5; break;
    case NoiseGenerator::range_corrected: value = (lattice_sum(p) + kRangeOffset) * kRangeScale; break;
    case NoiseGenerator::perlin: value = kPerlinMiddle + kPerlinScale * perlin(p); break;
  }
  return std::clamp(value, 0.0, 1.0);
}

Vec3 vector_noise(const Vec3& p) noexcept {
  Vec3 sum(0, 0, 0);
  for_corners(p, [&](const Corner& corner) { sum += Vec3(corner.at(0), corner.at(4), corner.at(8)); });
  return sum;
}

Vec3 vector_turbulence(const Vec3& p, const Octaves& octaves) noexcept {
  return sum_octaves<Vec3>(p, octaves, [](const Vec3& q) { return vector_noise(q); });
}

double turbulence(const Vec3& p, const Octaves& octaves, NoiseGenerator generator) noexcept {
  return sum_octaves<double>(p, octaves, [&](const Vec3& q) { return noise(q, generator); });
}

}  // namespace isl::values
