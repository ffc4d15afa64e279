// Eight rays that are traced together, one in every lane of an octet.
#pragma once

#include "renderer/scene/transform.h"

#include <cstddef>

namespace isl::render {

using scene::Vec3;

inline constexpr std::size_t kPacket = 8;

/// Rays in a blob's space, each with the stretch [t0, t1] to be searched. Lanes without a ray may hold any numbers.
struct RayPacket {
  alignas(64) double origin[3][kPacket]{};
  alignas(64) double direction[3][kPacket]{};
  alignas(64) double t0[kPacket]{};
  alignas(64) double t1[kPacket]{};

  [[nodiscard]] Vec3 origin_of(std::size_t lane) const { return {origin[0][lane], origin[1][lane], origin[2][lane]}; }
  [[nodiscard]] Vec3 direction_of(std::size_t lane) const {
    return {direction[0][lane], direction[1][lane], direction[2][lane]};
  }
};

}  // namespace isl::render
