// The hierarchy of boxes over the instances of a scene.
#pragma once

#include "renderer/compiled/compiled_scene.h"

namespace isl::render {

/// Fills `listed`, `bounds`, `clear_bounds`, `boxes` and `crowd` from the instances. They are of no use once `meter`
/// has refused.
void build_instance_boxes(CompiledScene& scene, Meter& meter);

}  // namespace isl::render
