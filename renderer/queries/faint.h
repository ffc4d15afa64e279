// Convolved components that have no surface by themselves: a segment that is short, or a ring that is small, compared
// with its radius gathers too little of its kernel to reach the threshold. Among others of its kind such a component
// works as it should.
#pragma once

#include "renderer/scene/database.h"

#include <cstdint>
#include <optional>

namespace isl::render {

struct FaintComponents {
  OriginId first;
  scene::Skeleton skeleton;  ///< skeleton of the first
  double greatest;           ///< greatest value of the first one's field, over the threshold
  std::uint64_t count;
};

/// Empty if every convolved component that adds to its blob reaches the threshold.
[[nodiscard]] std::optional<FaintComponents> faint_components(const scene::Database& database);

}  // namespace isl::render
