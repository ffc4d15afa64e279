// A light group as it is placed in the world.
#pragma once

#include "renderer/scene/ids.h"
#include "renderer/scene/transform.h"

namespace isl::render {

/// Lights that shine on the objects of a group alone.
struct LightGroup {
  scene::GroupId group;  ///< holds the lights, in its own space
  scene::Transform world_from_group;
  bool has_global_lights = false;  ///< the lights of the world shine on its objects too
};

}  // namespace isl::render
