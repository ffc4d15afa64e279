// The grid of one blob: cells classified from the ranges of their fields. Where the sum's upper bound stays below the
// threshold nothing can be seen; where its lower bound stays above, everything is inside; only the rest is ever solved.
#pragma once

#include "base/run_limits.h"
#include "renderer/fields/component_table.h"
#include "renderer/grid/grid.h"
#include "renderer/grid/grid_budget.h"

namespace isl::render {

/// The rule by which cells are classified.
enum class CellRule : std::uint8_t {
  ranges,     ///< by the ranges of their fields
  lipschitz,  ///< by values in their middles and Lipschitz constants, divided down to half the smallest support: the
              ///< octree of `lg`, with two of its levels to a brick (Kalra and Barr 1989)
  none,       ///< not at all: every cell that a support reaches keeps its list. The published solver needs this,
              ///< because its error moves the surface into cells where the true field has none.
};

/// The grid costs at most what `budget` allows, and is charged to it. It is empty once `meter` has refused; null:
/// without limit.
[[nodiscard]] Grid build_blob_grid(const ComponentTable& table, CellRule rule, GridBudget& budget,
                                   Meter* meter = nullptr);

}  // namespace isl::render
