// Convolved components that have no surface by themselves: a segment that is short, or a ring that is small, against its radius
// gathers too little of its kernel to reach the threshold. Among others of its kind it is what it should be.
#pragma once

#include "renderer/scene/database.h"

#include <cstdint>
#include <optional>

namespace isl::render {

struct FaintComponents {
  OriginId first;
  scene::Skeleton skeleton;  ///< of the first
  double greatest;           ///< value of the first, over the threshold
  std::uint64_t count;
};

/// Nothing if every convolved component that adds to its blob reaches the threshold.
[[nodiscard]] std::optional<FaintComponents> faint_components(const scene::Database& database);

}  // namespace isl::render
