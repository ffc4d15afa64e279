// The fields that a ray was last laid out against: their list, and the ray in the blob's space.
#pragma once

#include "renderer/scene/transform.h"

#include <cstdint>

namespace isl::render {

struct ComponentTable;

struct LaidOutFields {
  const ComponentTable* table = nullptr;
  const std::uint32_t* items = nullptr;
  std::uint32_t count = 0;
  scene::Vec3 origin{0}, direction{0};
};

}  // namespace isl::render
