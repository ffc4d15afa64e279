// The tables behind noise.h. Each comes from a generator that was published long before: a CRC, a linear congruential
// generator, Perlin's own initialisation. Internal to renderer/values.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace isl::values {

struct NoiseTables {
  static constexpr std::size_t kHashes = 4096;       ///< a power of two, because lattice coordinates are taken modulo
                                                     ///< it
  static constexpr std::size_t kSlopes = 256;        ///< number of different lattice points
  static constexpr std::size_t kTermsOfVector = 12;  ///< a value and a slope, three times
  static constexpr std::size_t kGradients = 2048;    ///< for Perlin's noise

  /// A permutation of the numbers below kHashes.
  std::array<std::uint16_t, kHashes> hash;
  /// The number of a lattice point among those that differ: its hash modulo kSlopes.
  std::array<std::uint16_t, kHashes> point;
  /// Random numbers in [−1, 1]; a lattice point of number n owns those from index n on.
  std::array<double, kSlopes + kTermsOfVector - 1> terms;
  /// The same by lattice point, so that what a corner needs lies together: half of the value, and the slope.
  using Slope = std::array<double, 4>;
  alignas(64) std::array<Slope, kSlopes> slopes;
  /// And for vectors: the same four, each for x, y and z, and a zero.
  using VectorSlope = std::array<std::array<double, 4>, 4>;
  alignas(64) std::array<VectorSlope, kSlopes> vector_slopes;

  /// Perlin's permutation and unit vectors, each followed by a copy of itself, so that sums of two need no modulo.
  std::array<std::uint16_t, 2 * kGradients + 2> permutation;
  std::array<std::array<double, 3>, 2 * kGradients + 2> gradients;
};

/// The tables are made at the first call.
[[nodiscard]] const NoiseTables& noise_tables() noexcept;

}  // namespace isl::values
