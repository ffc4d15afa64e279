// The lights of a scene as they stand in the world, with those of light groups.
#pragma once

#include "renderer/scene/database.h"
#include "renderer/shading/area_points.h"
#include "renderer/trace/tracer.h"

#include <optional>
#include <vector>

namespace isl::render {

struct PlacedLight {
  scene::Light light;
  std::uint32_t group = scene::kNone;     ///< the index in Tracer::light_groups() of its light group, if it is in one
  std::uint32_t number = 0;               ///< among all lights
  std::optional<AreaPoints> scattered{};  ///< if the points of its area are at random places
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
  for (std::size_t i = 0; i < lights.size(); ++i) {
    lights[i].number = static_cast<std::uint32_t>(i);
    const std::optional<scene::AreaLight>& area = lights[i].light.area;
    if (area && area->jitter) lights[i].scattered.emplace(*area);
  }
  return lights;
}

}  // namespace isl::render
