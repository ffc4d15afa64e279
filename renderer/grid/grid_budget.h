// Limits of the cost of grids. Cells that would exceed them stay undivided, which is right and slower to trace.
#pragma once

#include "base/run_limits.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace isl::render {

/// The cost of a grid, or its limit.
struct GridCost {
  std::size_t bytes = 0;  ///< of cells and lists
  std::size_t tests = 0;  ///< classifications of an item in a cell
};

/// Shares out what all grids of a scene may cost together. Each gets what its items are worth, so that large grids are
/// built in linear time. Small ones may cost more, out of a pool: a quarter of what is left in it.
class GridBudget {
 public:
  /// `most_bytes`: limit of all grids together.
  explicit GridBudget(std::size_t most_bytes = std::numeric_limits<std::size_t>::max()) : bytes_left_(most_bytes) {}

  [[nodiscard]] GridCost limit(std::size_t items) const {
    const GridCost own = worth(items);
    return {std::min({std::max(own.bytes, pool_.bytes / 4), kMostBytes, bytes_left_}),
            std::max(own.tests, pool_.tests / 4)};
  }
  void spend(std::size_t items, const GridCost& cost) {
    const GridCost own = worth(items);
    if (cost.bytes > own.bytes) pool_.bytes -= std::min(pool_.bytes, cost.bytes - own.bytes);
    if (cost.tests > own.tests) pool_.tests -= std::min(pool_.tests, cost.tests - own.tests);
    bytes_left_ -= std::min(bytes_left_, cost.bytes);
  }

 private:
  [[nodiscard]] static constexpr GridCost worth(std::size_t items) { return {items * 1000, items * 2000}; }

  /// Lists are found by numbers of 32 bits.
  static constexpr std::size_t kMostBytes = std::size_t{1} << 34;

  GridCost pool_{std::size_t{256} << 20, 24'000'000};
  std::size_t bytes_left_;
};

/// The limit of a grid of so many items. It is also at most an eighth of the memory that is left, because its lists are
/// there twice while they grow, beside those of two levels of open cells and of the cells on trial. `meter` may be
/// null.
[[nodiscard]] inline GridCost limit_of(const GridBudget& budget, std::size_t items, const Meter* meter) {
  GridCost limit = budget.limit(items);
  if (meter != nullptr) limit.bytes = std::min(limit.bytes, meter->left() / 8);
  return limit;
}

}  // namespace isl::render
