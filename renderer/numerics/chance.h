// Random numbers that depend on a place alone, so that pictures are the same whatever computes them.
#pragma once

#include <bit>
#include <cstdint>

namespace isl::render {

/// A number from 0 up to, not including, 1, for the place (x, y, z). It has nothing to do with the numbers at other
/// places, nor with those at the same one with another `salt`. By the finalizer of splitmix64 (Steele, Lea, Flood,
/// 2014).
[[nodiscard]] inline double chance_at(double x, double y, double z, std::uint64_t salt = 0) {
  std::uint64_t bits = salt;
  for (const double term : {x, y, z}) {
    bits += std::bit_cast<std::uint64_t>(term) + 0x9e3779b97f4a7c15;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
    bits ^= bits >> 31;
  }
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

}  // namespace isl::render
