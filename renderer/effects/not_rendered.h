// Effects that the language has and the renderer does not draw yet: their records have no stage, so that a scene that calls for
// one is refused by name, or with `--lenient` is rendered without. Whoever makes one drawable gives it a file and a row of
// effects.def, and takes it out here.
#pragma once

#include "renderer/effects/effect.h"

#include <vector>

namespace isl::render {

[[nodiscard]] std::vector<Effect> effects_not_rendered();

/// Parts of the above: cameras, lights, objects and the air; and what surfaces look like.
void add_world_not_rendered(std::vector<Effect>& effects);
void add_surfaces_not_rendered(std::vector<Effect>& effects);

}  // namespace isl::render
