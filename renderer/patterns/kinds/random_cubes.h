// Random numbers of the unit cubes of space, for cellular patterns and turbulent black holes. They come from
// std::mt19937 with its default seed, indexed by the hash of noise.
#pragma once

#include "renderer/scene/transform.h"
#include "renderer/values/noise_tables.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace isl::render {

struct Cube {
  int x = 0, y = 0, z = 0;
};

/// The cube at the given offset. Coordinates beyond the integers' range wrap around.
[[nodiscard]] inline Cube neighbour(const Cube& cube, int dx, int dy, int dz) noexcept {
  const auto add = [](int a, int b) {
    return static_cast<int>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
  };
  return {add(cube.x, dx), add(cube.y, dy), add(cube.z, dz)};
}

/// The cube around p.
[[nodiscard]] Cube cube_of(const scene::Vec3& p) noexcept;

/// The random numbers of all cubes.
class RandomCubes {
 public:
  RandomCubes() noexcept;

  /// The cube's random numbers in [0, 1): the first is its own, the others overlap with those of other cubes.
  [[nodiscard]] const double* of(const Cube& cube) const noexcept {
    constexpr std::uint32_t kMask = values::NoiseTables::kHashes - 1;
    const std::uint32_t of_x = hashes_[static_cast<std::uint32_t>(cube.x) & kMask];
    const std::uint32_t of_xy = hashes_[of_x ^ (static_cast<std::uint32_t>(cube.y) & kMask)];
    return &numbers_[hashes_[of_xy ^ (static_cast<std::uint32_t>(cube.z) & kMask)]];
  }

 private:
  static constexpr std::size_t kNumbersOfCube = 3;
  decltype(values::NoiseTables::hash) hashes_;
  std::array<double, values::NoiseTables::kHashes + kNumbersOfCube - 1> numbers_{};
};
[[nodiscard]] const RandomCubes& random_cubes() noexcept;

}  // namespace isl::render
