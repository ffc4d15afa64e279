// The top-level grid: it tells which instances a ray may meet in each cell, from their bounding boxes.
#pragma once

#include "renderer/compiled/compiled_scene.h"

namespace isl::render {

/// Fills `unbounded`, `bounded`, `bounds` and `grid` from the instances. The grid costs at most what `budget`
/// allows, and is charged to it. It is empty once `meter` has refused.
void build_instance_grid(CompiledScene& scene, GridBudget& budget, Meter& meter);

}  // namespace isl::render
