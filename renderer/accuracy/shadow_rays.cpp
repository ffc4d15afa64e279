#include "renderer/accuracy/shadow_rays.h"

#include "base/check.h"
#include "renderer/accuracy/ray_blocks.h"
#include "renderer/shading/lighting.h"

namespace isl::render {
namespace {

/// Appends the shadow rays of one camera ray. Lights behind the surface are left out (shading/lighting.h).
void add_shadow_rays(const scene::Database& database, const Tracer& tracer, const Ray& ray, SurfacePoint& point,
                     std::vector<Ray>& shadows) {
  Hit hit;
  TraceCounters counters;
  tracer.first_hits(std::span(&ray, 1), std::span(&hit, 1), counters);
  if (hit.is_miss()) return;
  tracer.surface_at(ray, hit, point);
  const Vec3 normal = turned_to_viewer(point.normal, ray.direction);
  for (const scene::Light& light : database.lights) {
    const LightSample sample = sample_light(light, point.position);
    if (light.shadowless || !(normal.dot(sample.direction) > 0)) continue;
    shadows.push_back({point.position, sample.direction, sample.distance, ray.path_length + hit.t, hit.start()});
  }
}

}  // namespace

std::vector<Ray> shadow_rays(const scene::Database& database, const Tracer& reference, std::span<const Ray> rays,
                             const StopFlag* stop) {
  std::vector<std::vector<Ray>> of_block((rays.size() + kBlock - 1) / kBlock);
  in_blocks(rays.size(), stop, {}, [&](std::size_t first, std::size_t count) {
    SurfacePoint point;
    for (const Ray& ray : rays.subspan(first, count)) {
      add_shadow_rays(database, reference, ray, point, of_block[first / kBlock]);
    }
  });
  std::vector<Ray> all;
  for (const std::vector<Ray>& block : of_block) all.insert(all.end(), block.begin(), block.end());
  return all;
}

std::vector<std::uint8_t> occlusions_of(const Tracer& tracer, std::span<const Ray> rays, const StopFlag* stop) {
  std::vector<std::uint8_t> occluded(rays.size());
  in_blocks(rays.size(), stop, {}, [&](std::size_t first, std::size_t count) {
    TraceCounters counters;
    tracer.occlusions(rays.subspan(first, count), std::span(occluded).subspan(first, count), counters);
  });
  return occluded;
}

ShadowSummary summarise_shadows(std::span<const std::uint8_t> found, std::span<const std::uint8_t> reference) {
  ISL_CHECK(found.size() == reference.size(), "{} {}", found.size(), reference.size());
  ShadowSummary summary{.rays = found.size()};
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool is_dark = found[i] == kOccluded, should_be = reference[i] == kOccluded;
    if (!is_dark && should_be) ++summary.leaks;
    if (is_dark && !should_be) ++summary.false_shadows;
  }
  return summary;
}

}  // namespace isl::render
