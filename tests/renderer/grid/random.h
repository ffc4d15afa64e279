// Random numbers and points for the tests of grids, the same on every machine.
#pragma once

#include "renderer/grid/grid.h"

#include <random>

namespace isl::render {

class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  Vec3 in_cube() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }

 private:
  std::mt19937_64 bits_;
};

}  // namespace isl::render
