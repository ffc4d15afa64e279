// The grid of one blob: cells classified from the ranges of their fields. Where the sum's upper bound stays below the threshold
// nothing can be seen; where its lower bound stays above, everything is inside; only the rest is ever solved.
#pragma once

#include "renderer/fields/component_table.h"
#include "renderer/grid/grid.h"

namespace isl::render {

struct BlobGridOptions {
  /// Off: every cell that a support reaches keeps its list. The published solver needs that: its error moves the surface into
  /// cells where the true field has none.
  bool classify = true;
};

[[nodiscard]] Grid build_blob_grid(const ComponentTable& table, const BlobGridOptions& options);

}  // namespace isl::render
