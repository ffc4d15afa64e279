// Sizes and counts of a compiled scene's grids, by kind of cell and depth, as stable JSON for `isl dump --stage grid`.
#pragma once

#include "renderer/compiled/compiled_scene.h"

#include <string>

namespace isl::render {

[[nodiscard]] std::string grid_json(const CompiledScene& scene);

}  // namespace isl::render
