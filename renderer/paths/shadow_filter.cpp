#include "renderer/paths/shadow_filter.h"

#include "renderer/numerics/power.h"
#include "renderer/shading/lighting.h"

namespace isl::render {

Rgb ShadowFilter::share_at(const Ray& ray, const Hit& hit, std::uint32_t& list, Bodies& bodies,
                           ShadowFilterMemory& memory, TraceCounters& counters) const {
  SurfacePoint& surface = memory.surface;
  tracer_.surface_at(ray, hit, surface, counters);
  memory.textures.clear();
  memory.normals.clear();
  memory.passing.clear();
  const LayerLists lists{turned_to_viewer(surface.normal, ray.direction), has_bumps_ ? &memory.normals : nullptr,
                         &memory.passing, ray.direction};
  if (!textures_.append(surface, memory.textures, memory.texture_bytes, lists)) {
    refusals_.report("this object", tracer_.origin_of(hit));
    return Rgb(0);
  }
  const Medium& medium = interiors_[surface.interior];
  Rgb share(0);
  for (std::size_t i = 0; i < memory.textures.size(); ++i) {
    Rgb passing = memory.passing[i] * memory.textures[i].weight;
    if (medium.caustics > 0 && passing != Rgb(0)) {
      // Light that a lens gathers, as POV-Ray fakes it.
      constexpr double kSharpness = 45;
      const Vec3& normal = has_bumps_ ? memory.normals[i] : lists.normal;
      passing *= 1 + power(std::abs(normal.dot(ray.direction)), kSharpness * medium.caustics);
    }
    share += passing;
  }
  if (surface.interior == scene::kNoInterior) return share;
  const std::optional<std::uint32_t> rest = bodies.left(list, surface.body);
  const bool leaves = rest.has_value();
  list = leaves ? *rest : bodies.entered(list, {surface.body, surface.interior, surface.is_hollow});
  return leaves && medium.fade_power > 0 ? share * medium.left_after(hit.t) : share;
}

void ShadowFilter::run(std::span<const Ray> rays, RayKind kind, std::span<const std::uint32_t> begin_in,
                       std::span<Rgb> shares, std::span<Certainty> certainties, Bodies& bodies,
                       ShadowFilterMemory& memory, TraceCounters& counters) const {
  // Most rays end at an opaque object, whatever they meet before it, or meet nothing.
  memory.occluded.resize(rays.size());
  tracer_.occlusions(rays, memory.occluded, counters, with(kind, kOnlyOpaque));
  memory.rays.clear();
  memory.numbers.clear();
  memory.bodies_of.clear();
  for (std::uint32_t i = 0; i < rays.size(); ++i) {
    shares[i] = Rgb(memory.occluded[i] == kOccluded ? 0 : 1);
    if (memory.occluded[i] == kOccluded) continue;
    if (memory.occluded[i] == kUndecidedOcclusion) lower(certainties[i], Certainty::undecided);
    if (!tracer_.may_meet_clear(rays[i])) continue;
    memory.rays.push_back(rays[i]);
    memory.numbers.push_back(i);
    memory.bodies_of.push_back(begin_in[i]);
  }
  // Every step takes all rays that have not ended past one more surface.
  while (!memory.rays.empty()) {
    memory.hits.assign(memory.rays.size(), Hit{});
    tracer_.first_hits(memory.rays, memory.hits, counters, with(kind, kOnlyClear));
    if (refusals_.is_set()) return;
    std::size_t left = 0;
    for (std::size_t i = 0; i < memory.rays.size(); ++i) {
      const Hit& hit = memory.hits[i];
      const std::uint32_t number = memory.numbers[i];
      if (hit.is_miss()) {
        lower(certainties[number], hit.certainty);
        continue;
      }
      Ray ray = memory.rays[i];
      std::uint32_t list = memory.bodies_of[i];
      shares[number] *= share_at(ray, hit, list, bodies, memory, counters);
      if (shares[number] == Rgb(0)) continue;
      lower(certainties[number], hit.certainty);
      ray.origin = memory.surface.position;
      ray.t_max -= hit.t;
      ray.path_length += hit.t;
      ray.start = hit.start();
      memory.rays[left] = ray;
      memory.bodies_of[left] = list;
      memory.numbers[left++] = number;
    }
    memory.rays.resize(left);
    memory.numbers.resize(left);
  }
}

}  // namespace isl::render
