// Effects that the language has and the renderer does not draw yet. Their records have no stage, so that a scene that
// calls for one is refused by name, or is rendered without it if `--lenient` is given. To make one drawable, give it a
// file and a row of effects.def, and remove it here.
#pragma once

#include "renderer/effects/effect.h"

#include <vector>

namespace isl::render {

[[nodiscard]] std::vector<Effect> effects_not_rendered();

}  // namespace isl::render
