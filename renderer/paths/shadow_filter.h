// Light of shadow rays through what lets light through: it goes straight on, is filtered by every surface, and fades on
// its way through bodies.
#pragma once

#include "renderer/paths/contacts.h"
#include "renderer/rays/trace_counters.h"
#include "renderer/shading/interiors.h"
#include "renderer/shading/point_refusals.h"
#include "renderer/shading/point_textures.h"
#include "renderer/trace/tracer.h"

#include <cstdint>
#include <span>
#include <vector>

namespace isl::render {

/// The place at which a path ends, and from which light is asked for.
struct LightBegin {
  std::uint32_t bodies = 0;   ///< PathEntry::bodies
  std::uint32_t contact = 0;  ///< PathEntry::contact
};

/// Memory of one thread.
struct ShadowFilterMemory {
  std::vector<Ray> rays;
  std::vector<std::uint8_t> occluded;
  std::vector<Hit> hits;
  std::vector<CoincidingHit> coinciding;
  std::vector<std::uint32_t> numbers;
  std::vector<std::uint32_t> bodies_of;  ///< by ray, the list of those that it is in
  SurfacePoint surface;
  std::vector<LitTexture> textures;
  std::vector<Vec3> normals;
  std::vector<Rgb> passing;
  Charge texture_bytes;
};

class ShadowFilter {
 public:
  ShadowFilter(const scene::Database& database, const Tracer& tracer, const PointTextures& textures,
               PointRefusals& refusals, bool has_bumps)
      : interiors_(database), tracer_(tracer), textures_(textures), refusals_(refusals), has_bumps_(has_bumps) {}

  /// shares[i] becomes the share of light that comes along rays[i], and certainties[i] falls where that is undecided.
  /// `lists` are those of the paths, to which others may be added.
  void run(std::span<const Ray> rays, RayKind kind, std::span<const LightBegin> begin_in, std::span<Rgb> shares,
           std::span<Certainty> certainties, PathLists& lists, ShadowFilterMemory& memory,
           TraceCounters& counters) const;

 private:
  /// The share of light that passes the surface, after its way to it in the bodies of `list`, which becomes the list
  /// behind it.
  [[nodiscard]] Rgb share_at(const Ray& ray, const Hit& hit, std::uint32_t& list, Bodies& bodies,
                             ShadowFilterMemory& memory, TraceCounters& counters) const;

  /// The same where the ray crosses several faces at one place.
  [[nodiscard]] Rgb share_at_contact(const Ray& ray, std::span<const CoincidingHit> hits, std::uint32_t& list,
                                     Bodies& bodies, ShadowFilterMemory& memory, TraceCounters& counters) const;
  /// The same of the faces that a ray of a kind crosses at once, because it begins at a face of a contact.
  [[nodiscard]] Rgb share_at_begin(const Ray& ray, RayKind kind, ContactFace begin, std::uint32_t& list,
                                   PathLists& lists, ShadowFilterMemory& memory, TraceCounters& counters) const;

  Interiors interiors_;
  const Tracer& tracer_;
  const PointTextures& textures_;
  PointRefusals& refusals_;
  bool has_bumps_;
};

}  // namespace isl::render
