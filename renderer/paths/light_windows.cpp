#include "renderer/paths/light_windows.h"

namespace isl::render {

LightWindows::LightWindows(const scene::Database& database, const RunLimits& run,
                           std::optional<scene::Refusal>& refusal) {
  const auto prepare = [&](const std::vector<scene::Light>& lights) {
    for (const scene::Light& light : lights) {
      if (refusal || !has_window(light) || objects_.contains(light.projected_through)) continue;
      scene::Object group;
      group.kind = scene::Object::Kind::group;
      group.shape = index(light.projected_through);
      std::unique_ptr<const ObjectTracer> object = ObjectTracer::of(database, group, run, refusal);
      if (refusal) refusal->origin = light.origin;
      if (object) objects_.emplace(light.projected_through, std::move(object));
    }
  };
  prepare(database.lights);
  for (const scene::Group& group : database.groups) prepare(group.lights);
}

void LightWindows::trim(const scene::Light& light, std::span<Ray> rays) const {
  const auto object = objects_.find(light.projected_through);
  if (object == objects_.end()) return;
  const scene::Transform& world_from_object = light.world_from_projected;
  TraceCounters counters;
  std::vector<Ray> inner(rays.size());
  std::vector<double> lengths(rays.size());
  std::vector<Hit> hits(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Vec3 direction = world_from_object.inverse_vector(rays[i].direction);
    lengths[i] = direction.length();
    if (!(lengths[i] > 0)) continue;  // at the light itself
    inner[i].origin = world_from_object.inverse_point(rays[i].origin);
    inner[i].direction = direction / lengths[i];
    inner[i].t_max = rays[i].t_max * lengths[i];
  }
  object->second->tracer().first_hits(inner, hits, counters, RayKind::query);
  for (std::size_t i = 0; i < rays.size(); ++i) rays[i].t_max = hits[i].is_miss() ? -1 : hits[i].t / lengths[i];
}

}  // namespace isl::render
