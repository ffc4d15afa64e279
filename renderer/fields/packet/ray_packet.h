// Eight rays that are traced together, one in every lane of an octet.
#pragma once

#include <cstddef>

namespace isl::render {

inline constexpr std::size_t kPacket = 8;

/// Rays in a blob's space, each with the stretch [t0, t1] to be searched. Lanes without a ray may hold any numbers.
struct RayPacket {
  alignas(64) double origin[3][kPacket]{};
  alignas(64) double direction[3][kPacket]{};
  alignas(64) double length2[kPacket]{};      ///< |direction|²
  alignas(64) double per_length2[kPacket]{};  ///< 1 / |direction|²
  alignas(64) double t0[kPacket]{};
  alignas(64) double t1[kPacket]{};
};

}  // namespace isl::render
