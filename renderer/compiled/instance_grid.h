// The top-level grid: which placed solids and blobs a ray may meet where, by their boxes.
#pragma once

#include "renderer/compiled/compiled_scene.h"

namespace isl::render {

/// Fills `unbounded`, `bounded`, `bounds` and `grid` from the instances.
void build_instance_grid(CompiledScene& scene);

}  // namespace isl::render
