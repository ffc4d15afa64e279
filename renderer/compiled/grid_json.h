// What a compiled scene's grids look like, for `isl dump --stage grid`: sizes and counts by kind and depth, as stable JSON.
#pragma once

#include "renderer/compiled/compiled_scene.h"

#include <string>

namespace isl::render {

[[nodiscard]] std::string grid_json(const CompiledScene& scene);

}  // namespace isl::render
