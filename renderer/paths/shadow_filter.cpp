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
  const LayerLists lists{.normal = turned_to_viewer(surface.normal, ray.direction),
                         .normals = has_bumps_ ? &memory.normals : nullptr,
                         .passing = &memory.passing,
                         .view = ray.direction};
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

Rgb ShadowFilter::share_at_contact(const Ray& ray, std::span<const CoincidingHit> hits, std::uint32_t& list,
                                   Bodies& bodies, ShadowFilterMemory& memory, TraceCounters& counters) const {
  const std::vector<CrossedFace> faces = in_order(hits, tracer_, bodies, list, counters);
  Rgb share = share_at(ray, faces.front().hit, list, bodies, memory, counters);
  const Ray beyond = continued(ray, faces.front().hit);
  for (std::size_t i = 1; i < faces.size(); ++i) {
    Hit at_once = faces[i].hit;
    at_once.t = 0;
    share *= share_at(beyond, at_once, list, bodies, memory, counters);
  }
  return share;
}

Rgb ShadowFilter::share_at_begin(const Ray& ray, RayKind kind, ContactFace begin, std::uint32_t& list, PathLists& lists,
                                 ShadowFilterMemory& memory, TraceCounters& counters) const {
  Rgb share(1);
  const auto next = [&](ContactFace face) { return lists.contacts.next(face, ray.direction, kind, tracer_); };
  for (ContactFace face = next(begin); face != 0; face = next(face))
    share *= share_at(ray, lists.contacts.hit_at(face), list, lists.bodies, memory, counters);
  return share;
}

void ShadowFilter::run(std::span<const Ray> rays, RayKind kind, std::span<const LightBegin> begin_in,
                       std::span<Rgb> shares, std::span<Certainty> certainties, PathLists& lists,
                       ShadowFilterMemory& memory, TraceCounters& counters) const {
  // Most rays end at an opaque object, whatever they meet before it, or meet nothing.
  memory.occluded.resize(rays.size());
  tracer_.occlusions(rays, memory.occluded, counters, with(kind, kOnlyOpaque));
  memory.rays.clear();
  memory.numbers.clear();
  memory.bodies_of.clear();
  const RayKind clear = with(kind, kOnlyClear);
  for (std::uint32_t i = 0; i < rays.size(); ++i) {
    shares[i] = Rgb(memory.occluded[i] == kOccluded ? 0 : 1);
    if (memory.occluded[i] == kOccluded) continue;
    if (memory.occluded[i] == kUndecidedOcclusion) lower(certainties[i], Certainty::undecided);
    std::uint32_t list = begin_in[i].bodies;
    if (begin_in[i].contact != 0)
      shares[i] = share_at_begin(rays[i], clear, begin_in[i].contact, list, lists, memory, counters);
    if (!tracer_.may_meet_clear(rays[i])) continue;
    memory.rays.push_back(rays[i]);
    memory.numbers.push_back(i);
    memory.bodies_of.push_back(list);
  }
  // Every step takes all rays that have not ended past one more surface.
  while (!memory.rays.empty()) {
    memory.hits.assign(memory.rays.size(), Hit{});
    memory.coinciding.clear();
    tracer_.first_hits(memory.rays, memory.hits, counters, clear, &memory.coinciding);
    if (refusals_.is_set()) return;
    std::span<const CoincidingHit> coinciding = memory.coinciding;
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
      if (!coinciding.empty() && coinciding.front().ray == &memory.rays[i]) {
        const std::span<const CoincidingHit> hits = of_one_ray(coinciding);
        coinciding = coinciding.subspan(hits.size());
        shares[number] *= share_at_contact(ray, hits, list, lists.bodies, memory, counters);
      } else {
        shares[number] *= share_at(ray, hit, list, lists.bodies, memory, counters);
      }
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
