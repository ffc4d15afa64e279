// The first surface of a CSG tree along a ray.
#pragma once

#include "renderer/compiled/compiled_scene.h"
#include "renderer/rays/blob_ray.h"
#include "renderer/rays/ray.h"
#include "renderer/trace/csg_state.h"
#include "renderer/trace/ray_faces.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace isl::render {

/// A ray in the tree's space; t is the same as in the world.
struct CsgRay {
  Vec3 origin, direction;
  double t_max = std::numeric_limits<double>::infinity();
  std::uint32_t start_leaf = scene::kNone;  ///< the leaf whose surface the ray starts on, if it is in this tree
  std::uint32_t start_part = 0;             ///< which surface of that leaf
  double path_length = 0;                   ///< the path's length before t = 0, in world units
  InstanceId instance = scene::kNone;       ///< the instance as which the tree is met
  const Ray* world = nullptr;               ///< the ray in the world
  bool wants_all = false;                   ///< all faces that are seen where the first is, in CsgMemory::seen
};

struct CsgHit {
  double t = std::numeric_limits<double>::infinity();
  std::uint32_t leaf = scene::kNone;
  std::uint32_t cell = scene::kNone;  ///< for a blob
  std::uint32_t part = 0;             ///< for a solid
  bool from_inside = false;           ///< the ray comes out of the whole; for an open surface, out of its back

  [[nodiscard]] bool is_miss() const { return leaf == scene::kNone; }
};

/// The search for a blob's first crossing. It is a pointer, because it is compiled for several vector widths elsewhere.
struct BlobSearch {
  void* context;
  BlobHit (*first_hit)(void* context, std::uint32_t blob, const BlobRay& ray);
};

/// A crossing of a leaf between inside and outside, or a meeting with an open surface.
struct CsgEvent {
  double t;
  std::uint32_t leaf;
  std::uint32_t cell;
  std::uint32_t part;
};

/// A leaf whose box a ray meets from t = `enter` on.
struct CsgEntry {
  double enter;
  std::uint32_t leaf;
};

/// Memory that is kept from ray to ray.
struct CsgMemory {
  CsgState state;
  std::vector<double> cuts;       ///< where the ray crosses each of the cutting planes
  std::vector<CsgEntry> entries;  ///< sorted
  std::vector<CsgEvent> events;   ///< a heap with the nearest first
  std::vector<CsgEvent> group;    ///< the events that are taken together
  std::vector<std::uint8_t> shown;
  std::vector<CsgHit> seen;  ///< the hit, and others at the same place if they are wanted
};

/// True if a half-line from t = 0 to t_max meets the bounds of a tree.
[[nodiscard]] bool meets_bounds(const CsgTree& tree, const CsgRay& ray);

/// `memory.entries` holds the leaves of `tree.boxes` whose boxes the ray meets, in any order.
[[nodiscard]] CsgHit first_csg_hit(const CompiledScene& scene, const CsgTree& tree, const CsgRay& ray, RayFaces& faces,
                                   const BlobSearch& blobs, CsgMemory& memory);

}  // namespace isl::render
