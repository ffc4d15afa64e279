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
  /// Random numbers in [−1, 1]; a lattice point of hash h owns those from index h on.
  std::array<double, kSlopes + kTermsOfVector - 1> terms;

  /// Perlin's permutation and unit vectors, each followed by a copy of itself, so that sums of two need no modulo.
  std::array<std::uint16_t, 2 * kGradients + 2> permutation;
  std::array<std::array<double, 3>, 2 * kGradients + 2> gradients;
};

/// The tables are made at the first call.
[[nodiscard]] const NoiseTables& noise_tables() noexcept;

}  // namespace isl::values
