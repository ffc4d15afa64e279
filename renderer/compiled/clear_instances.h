// Which instances may let light through.
#pragma once

#include "renderer/compiled/compiled_scene.h"

namespace isl::render {

/// Hides every instance from the rays that look for the other kind alone: those that may let light through from
/// kOnlyOpaque, all others from kOnlyClear.
void part_clear_from_opaque(const scene::Database& database, CompiledScene& scene);

}  // namespace isl::render
