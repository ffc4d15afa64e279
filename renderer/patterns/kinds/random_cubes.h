// Random numbers that belong to the unit cubes of space: what cellular patterns and uncertain black holes draw from.
// They come from std::mt19937 with its default seed, found by the hash of noise.
#pragma once

#include "renderer/scene/transform.h"

#include <cstdint>

namespace isl::render {

struct Cube {
  int x = 0, y = 0, z = 0;
};

/// The cube so many steps away. Beyond the whole numbers they begin again.
[[nodiscard]] inline Cube neighbour(const Cube& cube, int dx, int dy, int dz) noexcept {
  const auto add = [](int a, int b) {
    return static_cast<int>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
  };
  return {add(cube.x, dx), add(cube.y, dy), add(cube.z, dz)};
}

/// The cube around p.
[[nodiscard]] Cube cube_of(const scene::Vec3& p) noexcept;

/// The cube's numbers in [0, 1): the first is its own, the others it shares with others.
[[nodiscard]] const double* random_numbers(const Cube& cube) noexcept;

}  // namespace isl::render
