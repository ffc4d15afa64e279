#include "renderer/values/noise.h"

#include "renderer/values/integer.h"
#include "renderer/values/noise_tables.h"

#include <algorithm>
#include <bit>
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

/// Two numbers that are computed side by side. Both have the digits that they would have alone.
using Pair [[gnu::vector_size(16)]] = double;
using PairOfBits [[gnu::vector_size(16)]] = std::int64_t;
constexpr Pair kOne = {1, 1};

/// The lattice cell around a point. Arrays are by corner, the near one first.
struct Cell {
  double fraction[3];            ///< of the cell's edges, from the near corner to the point
  double weight[3][2];           ///< along each axis
  std::uint32_t point_xy[2][2];  ///< hashes, by x and y
  std::uint32_t z[2];            ///< coordinates modulo kHashes
};

/// Adding and subtracting this rounds numbers below kPlainCoordinate to integers, because its neighbours are the next
/// integers, and so are those of the sum.
constexpr double kUnits = 0x1.8p52, kPlainCoordinate = 0x1p51;

/// The lattice coordinate below p, and p's distance from it.
std::uint32_t cell_of(double p, double& fraction) {
  double below = 0;
  // The library's floor takes as long as the rest.
  if (std::abs(p) < kPlainCoordinate) [[likely]] {
    const double nearest = (p + kUnits) - kUnits;
    below = nearest > p ? nearest - 1 : nearest;
    fraction = p - below + 0.0;  // the sum makes 0 of −0
  } else {
    below = std::floor(p);
    fraction = std::isfinite(p) ? p - below : 0.0;
  }
  return static_cast<std::uint32_t>(to_integer(below)) + kLatticeOrigin;
}

Cell cell_around(const Vec3& p, const NoiseTables& tables) {
  constexpr std::uint32_t kMask = NoiseTables::kHashes - 1;
  const std::uint16_t* const hash = tables.hash.data();
  Cell cell;
  std::uint32_t at[3];
  for (int i = 0; i < 3; ++i) {
    at[i] = cell_of(p[i], cell.fraction[i]);
    cell.weight[i][1] = s_curve(cell.fraction[i]);
    cell.weight[i][0] = 1 - cell.weight[i][1];
  }
  const std::uint32_t y[2] = {at[1] & kMask, (at[1] + 1) & kMask};
  for (std::uint32_t dx = 0; dx < 2; ++dx) {
    const std::uint32_t of_x = hash[(at[0] + dx) & kMask];
    for (int dy = 0; dy < 2; ++dy) cell.point_xy[dx][dy] = hash[of_x ^ y[dy]];
  }
  for (std::uint32_t dz = 0; dz < 2; ++dz) cell.z[dz] = (at[2] + dz) & kMask;
  return cell;
}

/// The sum of the corners' linear functions, x first, then y, then z: the order is part of the value.
double lattice_sum(const Vec3& p) {
  const NoiseTables& tables = noise_tables();
  const Cell cell = cell_around(p, tables);
  const Pair x = {cell.fraction[0], cell.fraction[0] - 1}, of_x = {cell.weight[0][0], cell.weight[0][1]};
  double sum = 0;
  for (int dz = 0; dz < 2; ++dz) {
    for (int dy = 0; dy < 2; ++dy) {
      const auto slope = [&](int dx) -> const NoiseTables::Slope& {
        return tables.slopes.data()[tables.point.data()[cell.point_xy[dx][dy] ^ cell.z[dz]]];
      };
      const NoiseTables::Slope &a = slope(0), &b = slope(1);
      const double y = cell.fraction[1] - dy, z = cell.fraction[2] - dz;
      const Pair value =
          Pair{a.half_value, b.half_value} + Pair{a.x, b.x} * x + Pair{a.y, b.y} * y + Pair{a.z, b.z} * z;
      const Pair weighed = of_x * cell.weight[1][dy] * cell.weight[2][dz] * value;
      sum += weighed[0];
      sum += weighed[1];
    }
  }
  return sum;
}

/// The sums at two points, or nothing if one is far out. Both have the digits of lattice_sum: only what is computed
/// side by side differs.
bool lattice_sums(const Vec3& p, const Vec3& q, Pair& sums) {
  constexpr std::uint32_t kMask = NoiseTables::kHashes - 1;
  const NoiseTables& tables = noise_tables();
  const std::uint16_t *const hash = tables.hash.data(), *const number = tables.point.data();
  const NoiseTables::Slope* const slopes = tables.slopes.data();
  Pair from_corner[3][2], weight[3][2];
  std::uint32_t at[3][2];
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(p[i]) < kPlainCoordinate && std::abs(q[i]) < kPlainCoordinate)) return false;
    const Pair t = {p[i], q[i]};
    const Pair nearest = (t + kUnits) - kUnits;
    const Pair below = nearest - std::bit_cast<Pair>((nearest > t) & std::bit_cast<PairOfBits>(kOne));
    // The low bits of the sum are those of the integer. Those that do not fit have the low bits of to_integer's −2³¹.
    const PairOfBits cell = std::bit_cast<PairOfBits>(below + kUnits) & (below < 0x1p31) & (below >= -0x1p31);
    const Pair fraction = t - below + 0.0;
    from_corner[i][0] = fraction;
    from_corner[i][1] = fraction - 1;
    weight[i][1] = fraction * fraction * (3 - 2 * fraction);
    weight[i][0] = 1 - weight[i][1];
    at[i][0] = static_cast<std::uint32_t>(cell[0]) + kLatticeOrigin;
    at[i][1] = static_cast<std::uint32_t>(cell[1]) + kLatticeOrigin;
  }
  std::uint32_t of_xy[2][2][2];  // by point, x and y
  for (std::uint32_t i = 0; i < 2; ++i) {
    for (std::uint32_t dx = 0; dx < 2; ++dx) {
      const std::uint32_t of_x = hash[(at[0][i] + dx) & kMask];
      for (std::uint32_t dy = 0; dy < 2; ++dy) of_xy[i][dx][dy] = hash[of_x ^ ((at[1][i] + dy) & kMask)];
    }
  }
  Pair sum = {0, 0};
  for (std::uint32_t dz = 0; dz < 2; ++dz) {
    const std::uint32_t za = (at[2][0] + dz) & kMask, zb = (at[2][1] + dz) & kMask;
    for (int dy = 0; dy < 2; ++dy) {
      for (int dx = 0; dx < 2; ++dx) {
        const NoiseTables::Slope &a = slopes[number[of_xy[0][dx][dy] ^ za]], &b = slopes[number[of_xy[1][dx][dy] ^ zb]];
        const Pair value = Pair{a.half_value, b.half_value} + Pair{a.x, b.x} * from_corner[0][dx] +
                           Pair{a.y, b.y} * from_corner[1][dy] + Pair{a.z, b.z} * from_corner[2][dz];
        sum += weight[0][dx] * weight[1][dy] * weight[2][dz] * value;
      }
    }
  }
  sums = sum;
  return true;
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

/// The lattice noise whose sum is `sum`.
double noise_of(double sum, NoiseGenerator generator) {
  const double value = generator == NoiseGenerator::original ? sum + 0.5 : (sum + kRangeOffset) * kRangeScale;
  return std::clamp(value, 0.0, 1.0);
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
  if (generator == NoiseGenerator::perlin) return std::clamp(kPerlinMiddle + kPerlinScale * perlin(p), 0.0, 1.0);
  return noise_of(lattice_sum(p), generator);
}

std::array<double, 2> noise_at_two(const Vec3& p, const Vec3& q, NoiseGenerator generator) noexcept {
  Pair sums;
  if (generator == NoiseGenerator::perlin || !lattice_sums(p, q, sums))
    return {noise(p, generator), noise(q, generator)};
  return {noise_of(sums[0], generator), noise_of(sums[1], generator)};
}

Vec3 vector_noise(const Vec3& p) noexcept {
  const NoiseTables& tables = noise_tables();
  const Cell cell = cell_around(p, tables);
  const auto pair = [](const double(&terms)[2]) { return Pair{terms[0], terms[1]}; };
  Pair first_two = {0, 0};
  double third = 0;
  for (int dz = 0; dz < 2; ++dz) {
    for (int dy = 0; dy < 2; ++dy) {
      for (int dx = 0; dx < 2; ++dx) {
        const NoiseTables::VectorSlope& slope =
            tables.vector_slopes.data()[tables.point.data()[cell.point_xy[dx][dy] ^ cell.z[dz]]];
        const double weight = cell.weight[0][dx] * cell.weight[1][dy] * cell.weight[2][dz];
        const double x = cell.fraction[0] - dx, y = cell.fraction[1] - dy, z = cell.fraction[2] - dz;
        first_two += weight * (pair(slope.half_value) + pair(slope.x) * x + pair(slope.y) * y + pair(slope.z) * z);
        third += weight * (slope.third.half_value + slope.third.x * x + slope.third.y * y + slope.third.z * z);
      }
    }
  }
  return {first_two[0], first_two[1], third};
}

Vec3 vector_turbulence(const Vec3& p, const Octaves& octaves) noexcept {
  return sum_octaves<Vec3>(p, octaves, [](const Vec3& q) { return vector_noise(q); });
}

double turbulence(const Vec3& p, const Octaves& octaves, NoiseGenerator generator) noexcept {
  double sum = 0, weight = 1;
  for_octaves(p, octaves, generator, [&](double value) {
    sum += value * weight;
    weight *= octaves.omega;
  });
  return sum;
}

}  // namespace isl::values
