#include "renderer/patterns/kinds/random_cubes.h"

#include "renderer/values/integer.h"
#include "renderer/values/noise_tables.h"

#include <array>
#include <cmath>
#include <random>

namespace isl::render {
namespace {

using values::NoiseTables;

constexpr std::size_t kNumbersOfCube = 3;
using RandomTable = std::array<double, NoiseTables::kHashes + kNumbersOfCube - 1>;

const RandomTable& random_table() noexcept {
  static const RandomTable kTable = [] {
    RandomTable table{};
    std::mt19937 generator;
    for (double& number : table) number = static_cast<double>(generator()) * 0x1p-32;
    return table;
  }();
  return kTable;
}

}  // namespace

Cube cube_of(const scene::Vec3& p) noexcept {
  return {values::to_integer(std::floor(p.x)), values::to_integer(std::floor(p.y)),
          values::to_integer(std::floor(p.z))};
}

const double* random_numbers(const Cube& cube) noexcept {
  constexpr std::uint32_t kMask = NoiseTables::kHashes - 1;
  const auto& hashes = values::noise_tables().hash;
  const std::uint32_t of_x = hashes[static_cast<std::uint32_t>(cube.x) & kMask];
  const std::uint32_t of_xy = hashes[of_x ^ (static_cast<std::uint32_t>(cube.y) & kMask)];
  return &random_table()[hashes[of_xy ^ (static_cast<std::uint32_t>(cube.z) & kMask)]];
}

}  // namespace isl::render
