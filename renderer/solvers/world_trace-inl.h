// One ray against everything: half-spaces, then the top-level grid's instances in order of the cells they stand in, each in
// its own space. t is the same in all spaces, since directions are transformed and not normalised again.
#if defined(ISL_RENDERER_SOLVERS_WORLD_TRACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_WORLD_TRACE_INL_H_
#undef ISL_RENDERER_SOLVERS_WORLD_TRACE_INL_H_
#else
#define ISL_RENDERER_SOLVERS_WORLD_TRACE_INL_H_
#endif

#include "renderer/solids/solid.h"
#include "renderer/grid/grid_walk-inl.h"
#include "renderer/solvers/blob_ray.h"
#include "renderer/trace_kernel.h"

#include <array>
#include <cmath>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// `Search` has BlobHit first_hit(const CompiledBlob&, const SolverSettings&, TraceMemory&, TraceCounters&, const BlobRay&), and
/// for trace_packet() also takes_packets(const CompiledBlob&) and
/// first_hits(const CompiledBlob&, const SolverSettings&, TraceMemory&, TraceCounters&, const BlobRay*, std::uint32_t rays, BlobHit*).
template <class Search>
class WorldTrace {
 public:
  WorldTrace(const CompiledScene& scene, const SolverSettings& settings, TraceMemory& memory, TraceCounters& counters)
      : scene_(scene), settings_(settings), memory_(memory), counters_(counters) {}

  /// With `any`, the first thing found that throws a shadow ends the search, and only whether there is one is told.
  [[nodiscard]] Hit trace(const Ray& ray, bool any) {
    Hit best;
    best.t = ray.t_max;
    if (!is_sound(ray)) {
      best.t = std::numeric_limits<double>::infinity();
      return best;
    }
    for (const std::uint32_t instance : scene_.unbounded) {
      if (meet(instance, ray, any, best) && any) return best;
    }
    const Grid& grid = scene_.grid;
    if (scene_.bounded.size() <= kFewInstances) {
      for (const std::uint32_t instance : scene_.bounded) {
        if (meet(instance, ray, any, best) && any) return best;
      }
    } else if (!grid.is_empty()) {
      const BoxSpan span = clip_to_box(grid.box, ray.origin, ray.direction, 0, best.t);
      if (span.enter < span.leave) {
        recent_.fill(scene::kNone);
        walk(grid, ray.origin, ray.direction, span.enter, span.leave,
             [&](std::uint32_t, const Cell& cell, double t0, double) HWY_ATTR {
               if (t0 > best.t) return true;
               for (std::uint32_t i = 0; i < cell.count(); ++i) {
                 const std::uint32_t instance = grid.items[cell.first + i];
                 std::uint32_t& recent = recent_[instance % recent_.size()];
                 if (recent == instance) continue;
                 recent = instance;
                 if (meet(instance, ray, any, best) && any) return true;
               }
               return false;
             });
      }
    }
    if (best.is_miss()) best.t = std::numeric_limits<double>::infinity();
    return best;
  }

  /// The same of up to kPacket rays at once: what is met is met by all of them, and blobs that can be are searched for them
  /// together.
  void trace_packet(std::span<const Ray> rays, bool any, Hit* hits) {
    if (scene_.bounded.size() > kFewInstances) {
      for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = trace(rays[i], any);
      return;
    }
    std::uint32_t open = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      hits[i] = {};
      if (!is_sound(rays[i])) continue;
      hits[i].t = rays[i].t_max;
      open |= 1u << i;
    }
    for (const auto* const list : {&scene_.unbounded, &scene_.bounded}) {
      for (const std::uint32_t instance : *list) open = meet_packet(instance, rays, open, any, hits);
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (hits[i].is_miss()) hits[i].t = std::numeric_limits<double>::infinity();
    }
  }

 private:
  /// Up to here a list is quicker than a grid.
  static constexpr std::size_t kFewInstances = 3;

  [[nodiscard]] static bool is_sound(const Ray& ray) {
    const double sum = ray.origin.x + ray.origin.y + ray.origin.z + ray.direction.x + ray.direction.y + ray.direction.z;
    return std::isfinite(sum) && ray.direction.length2() > 0;
  }

  /// Lets the rays whose bit in `open` is set meet the instance; those that go on.
  std::uint32_t meet_packet(std::uint32_t index, std::span<const Ray> rays, std::uint32_t open, bool any, Hit* hits) {
    const Instance& instance = scene_.instances[index];
    const bool is_packed =
        instance.kind == scene::Object::Kind::blob && Search::takes_packets(scene_.blobs[instance.shape]);
    std::uint32_t met = 0;
    if (!is_packed) {
      for (std::size_t i = 0; i < rays.size(); ++i) {
        if ((open >> i & 1) != 0 && meet(index, rays[i], any, hits[i])) met |= 1u << i;
      }
    } else if (!(any && instance.no_shadow)) {
      BlobRay blob_rays[kPacket];
      BlobHit blob_hits[kPacket];
      for (std::size_t i = 0; i < rays.size(); ++i) blob_rays[i] = in_blob(index, rays[i], any, hits[i].t);
      Search::first_hits(scene_.blobs[instance.shape], settings_, memory_, counters_, blob_rays, open, blob_hits);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        if ((open >> i & 1) != 0 && improves(index, blob_hits[i], any, hits[i])) met |= 1u << i;
      }
    }
    return any ? open & ~met : open;
  }

  /// The ray in the space of an instance that is a blob.
  [[nodiscard]] BlobRay in_blob(std::uint32_t index, const Ray& ray, bool any, double t_max) const {
    const Instance& instance = scene_.instances[index];
    Vec3 origin = ray.origin, direction = ray.direction;
    if (instance.is_placed) {
      origin = instance.world_from_object.inverse_point(origin);
      direction = instance.world_from_object.inverse_vector(direction);
    }
    return {origin, direction, t_max, ray.start.instance == index, any, ray.path_length};
  }

  /// Whether the blob is met before `best`, which then is the new hit. With `any`, t is rough and within t_max.
  [[nodiscard]] bool improves(std::uint32_t index, const BlobHit& hit, bool any, Hit& best) const {
    if (hit.is_miss() || !(any || hit.t < best.t)) return false;
    best = {hit.t, index, hit.cell, 0, hit.from_inside != scene_.instances[index].is_inverse, scene::kNone};
    return true;
  }

  /// Whether the instance is met before `best`, which then is the new hit.
  bool meet(std::uint32_t index, const Ray& ray, bool any, Hit& best) {
    const Instance& instance = scene_.instances[index];
    if (any && instance.no_shadow) return false;
    if (instance.kind == scene::Object::Kind::blob) {
      const BlobHit hit = first_hit(scene_.blobs[instance.shape], in_blob(index, ray, any, best.t));
      return improves(index, hit, any, best);
    }
    Vec3 origin = ray.origin, direction = ray.direction;
    if (instance.is_placed) {
      origin = instance.world_from_object.inverse_point(origin);
      direction = instance.world_from_object.inverse_vector(direction);
    }
    const bool starts_here = ray.start.instance == index;
    if (instance.kind == scene::Object::Kind::group) {
      return meet_csg(index, {origin, direction, best.t, starts_here ? ray.start.leaf : scene::kNone, ray.start.part,
                              ray.path_length, reach_of(instance, ray, starts_here)},
                      best);
    }
    const scene::Solid& solid = scene_.solids[instance.shape];
    const Crossings found = crossings(solid, origin, direction, starts_here ? ray.start.part : kNoPart, scene_.details);
    for (int i = 0; i < found.count; ++i) {
      const double t = found.t[static_cast<std::size_t>(i)];
      if (!(t > 0)) continue;
      if (!(t < best.t)) return false;
      const std::uint8_t part = found.part[static_cast<std::size_t>(i)];
      const bool from_inside = !any && is_leaving(solid, part, origin + direction * t, direction) != instance.is_inverse;
      best = {t, index, scene::kNone, part, from_inside, scene::kNone};
      return true;
    }
    return false;
  }

  bool meet_csg(std::uint32_t index, const CsgRay& ray, Hit& best) {
    const Instance& instance = scene_.instances[index];
    const BlobSearch blobs{this, [](void* self, std::uint32_t blob, const BlobRay& blob_ray) {
                             auto& world = *static_cast<WorldTrace*>(self);
                             return world.first_hit(world.scene_.blobs[blob], blob_ray);
                           }};
    const CsgHit hit = first_csg_hit(scene_, scene_.trees[instance.shape], ray, blobs, memory_.csg);
    if (hit.is_miss()) return false;
    best = {hit.t, index, hit.cell, hit.part, hit.from_inside, hit.leaf};
    return true;
  }

  /// How large the numbers were that a ray's origin in an instance's space was computed from. A start on a surface was found
  /// at the end of a path.
  [[nodiscard]] static double reach_of(const Instance& instance, const Ray& ray, bool starts_here) {
    const auto largest = [](const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); };
    const double reach = largest(ray.origin) + (starts_here ? ray.path_length : 0);
    if (!instance.is_placed) return reach;
    const scene::Matrix& m = instance.world_from_object.inverse;
    const double stretch = std::max({largest({m[0][0], m[0][1], m[0][2]}), largest({m[1][0], m[1][1], m[1][2]}),
                                     largest({m[2][0], m[2][1], m[2][2]})});
    return reach * stretch + largest({m[3][0], m[3][1], m[3][2]});
  }

  [[nodiscard]] bool is_leaving(const scene::Solid& solid, std::uint8_t part, const Vec3& point, const Vec3& direction) const {
    return normal_at(solid, part, point, scene_.details).dot(direction) > 0;
  }

  [[nodiscard]] BlobHit first_hit(const CompiledBlob& blob, const BlobRay& ray) {
    return Search::first_hit(blob, settings_, memory_, counters_, ray);
  }

  const CompiledScene& scene_;
  const SolverSettings& settings_;
  TraceMemory& memory_;
  TraceCounters& counters_;
  std::array<std::uint32_t, 16> recent_;  ///< a mailbox: what the ray has met in the cells behind it
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
