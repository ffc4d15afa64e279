#include "renderer/paths/contacts.h"

#include "renderer/shading/lighting.h"

#include <algorithm>

namespace isl::render {

std::vector<CrossedFace> in_order(std::span<const CoincidingHit> hits, const Tracer& tracer, const Bodies& bodies,
                                  std::uint32_t list, TraceCounters& counters) {
  std::vector<CrossedFace> faces;
  SurfacePoint surface;
  for (const CoincidingHit& hit : hits) {
    tracer.surface_at(*hit.ray, hit.hit, surface, counters);
    faces.push_back(
        {hit.hit, -turned_to_viewer(surface.normal, hit.ray->direction), bodies.entered_after(list, surface.body)});
  }
  std::ranges::stable_sort(faces, [](const CrossedFace& a, const CrossedFace& b) {
    if (a.entered_after && b.entered_after) return *a.entered_after < *b.entered_after;
    return a.entered_after.has_value() && !b.entered_after.has_value();
  });
  return faces;
}

std::span<const CoincidingHit> of_one_ray(std::span<const CoincidingHit> hits) {
  const auto next = std::ranges::find_if(hits, [&](const CoincidingHit& hit) { return hit.ray != hits.front().ray; });
  return {hits.begin(), next};
}

ContactFace Contacts::add(std::span<const CrossedFace> faces) {
  const auto first = static_cast<ContactFace>(faces_.size());
  for (const CrossedFace& face : faces) {
    faces_.push_back(face);
    faces_.back().hit.t = 0;
  }
  faces_.emplace_back();
  return first;
}

ContactFace Contacts::next(ContactFace face, const Vec3& direction, RayKind kind, const Tracer& tracer) const {
  if (face == 0) return 0;
  const bool forward = direction.dot(faces_[face].forward) > 0;
  do {
    forward ? ++face : --face;
    if (faces_[face].hit.is_miss()) return 0;
  } while (tracer.is_hidden(faces_[face].hit, kind));
  return face;
}

}  // namespace isl::render
