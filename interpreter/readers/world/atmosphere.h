// `sky_sphere`, `fog`, `rainbow`: as values and at the top level of a scene.
#pragma once

#include "interpreter/element_stream.h"

namespace isl::interpreter {

// Each reads a whole block, which may begin with the name of a declared value.
[[nodiscard]] scene::SkySphere read_sky_sphere(Context& context, const Element& block);
[[nodiscard]] scene::Fog read_fog(Context& context, const Element& block);
[[nodiscard]] scene::Rainbow read_rainbow(Context& context, const Element& block);

// Each puts the block's content into the scene.
void place_sky_sphere(Context& context, const Element& block);
void place_fog(Context& context, const Element& block);
void place_rainbow(Context& context, const Element& block);

}  // namespace isl::interpreter
