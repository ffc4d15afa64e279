// The lights of a scene as they stand in the world, with those of light groups.
#pragma once

#include "renderer/scene/database.h"
#include "renderer/trace/tracer.h"

#include <vector>

namespace isl::render {

struct PlacedLight {
  scene::Light light;
  std::uint32_t group = scene::kNone;  ///< the index in Tracer::light_groups() of its light group, if it is in one
};

/// The lights of the world come first. Copies of a light group have copies of its lights.
[[nodiscard]] inline std::vector<PlacedLight> placed_lights(const scene::Database& database, const Tracer& tracer) {
  std::vector<PlacedLight> lights;
  lights.reserve(database.lights.size());
  for (const scene::Light& light : database.lights) lights.push_back({light});
  std::uint32_t number = 0;
  for (const LightGroup& group : tracer.light_groups()) {
    for (const scene::Light& light : database.groups[index(group.group)].lights) {
      lights.push_back({light, number});
      scene::move(lights.back().light, group.world_from_group);
    }
    ++number;
  }
  return lights;
}

}  // namespace isl::render
