// One ray or eight against the whole scene: listed instances first, then those in the hierarchy of boxes, nearest
// boxes first, each in its own space. t is the same in all spaces, since directions are transformed and not
// normalised again.
//
// Hits that coincide are resolved by trace/ray_faces.h. It is asked only about crossings close to the start or to one
// another.
#if defined(ISL_RENDERER_TRACE_WORLD_TRACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_TRACE_WORLD_TRACE_INL_H_
#undef ISL_RENDERER_TRACE_WORLD_TRACE_INL_H_
#else
#define ISL_RENDERER_TRACE_WORLD_TRACE_INL_H_
#endif

#include "renderer/boxes/box_walk-inl.h"
#include "renderer/compiled/blob_point-inl.h"
#include "renderer/rays/blob_ray.h"
#include "renderer/solids/first_crossings-inl.h"
#include "renderer/solids/solid.h"
#include "renderer/trace/csg_packet-inl.h"
#include "renderer/trace/octet_rays-inl.h"
#include "renderer/trace/ray_faces.h"
#include "renderer/trace/trace_entry_points.h"

#include <array>
#include <cmath>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// `Search` has
///   BlobHit first_hit(const CompiledBlob&, const SolverSettings&, TraceMemory&, TraceCounters&, const BlobRay&)
/// and, for trace_packet(),
///   bool takes_packets(const CompiledBlob&)
///   void first_hits(const CompiledBlob&, const SolverSettings&, TraceMemory&, TraceCounters&, const BlobRay*,
///                   std::uint32_t rays, BlobHit*).
template <class Search>
class WorldTrace {
 public:
  WorldTrace(const CompiledScene& scene, const SolverSettings& settings, RayKind kind, TraceMemory& memory,
             TraceCounters& counters)
      : scene_(scene),
        settings_(settings),
        memory_(memory),
        counters_(counters),
        kind_(static_cast<std::uint8_t>(kind)),
        faces_(scene, blob_gradient()) {}

  /// With `any`, the first hit that is found ends the search, and the result only tells whether there is one.
  [[nodiscard]] Hit trace(const Ray& ray, bool any) {
    Hit best;
    best.t = ray.t_max;
    undecided_from_ = std::numeric_limits<double>::infinity();
    if (!is_sound(ray)) {
      best.t = std::numeric_limits<double>::infinity();
      return best;
    }
    for (const std::uint32_t instance : scene_.listed) {
      if (meet(instance, ray, any, best) && any) return best;
    }
    if (!scene_.boxes.is_empty()) {
      walk_boxes(scene_.boxes, ray.origin, ray.direction, best.t, [&](std::uint32_t instance, double) HWY_ATTR {
        if (meet(instance, ray, any, best) && any) return kEnd;
        return any ? best.t : last_that_counts(ray, best);
      });
      if (any && !best.is_miss()) return best;
    }
    if (best.is_miss()) best.t = std::numeric_limits<double>::infinity();
    if (faces_.has_kept()) {
      best = faces_.first_declared(ray, best);
      faces_.forget();
    }
    judge(best, undecided_from_);
    return best;
  }

  /// Traces up to kPacket rays at once: each instance is met by all of them, and blobs that allow it are searched for
  /// them together.
  void trace_packet(std::span<const Ray> rays, bool any, Hit* hits) {
    std::uint32_t open = 0;
    rays_ = rays;
    are_octets_loaded_ = false;
    all_undecided_from_.fill(std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      hits[i] = {};
      if (!is_sound(rays[i])) continue;
      hits[i].t = limits_[i] = rays[i].t_max;
      open |= 1u << i;
    }
    for (const std::uint32_t instance : scene_.listed) open = meet_packet(instance, open, any, hits);
    if (open != 0 && !scene_.boxes.is_empty()) {
      const auto& [o, d] = octets().lines;
      walk_boxes(scene_.boxes, BoxRays({o.x, o.y, o.z}, {d.x, d.y, d.z}, open), limits_, open,
                 [&](std::uint32_t instance, std::uint32_t met)
                     HWY_ATTR { return meet_packet(instance, met, any, hits); });
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (hits[i].is_miss()) hits[i].t = std::numeric_limits<double>::infinity();
    }
    if (faces_.has_kept()) {
      for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = faces_.first_declared(rays[i], hits[i]);
      faces_.forget();
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (!(any && !hits[i].is_miss())) judge(hits[i], all_undecided_from_[i]);
    }
  }

 private:
  static constexpr double kEnd = -1;

  [[nodiscard]] static bool is_sound(const Ray& ray) {
    const double sum = ray.origin.x + ray.origin.y + ray.origin.z + ray.direction.x + ray.direction.y + ray.direction.z;
    return std::isfinite(sum) && ray.direction.length2() > 0;
  }

  /// Lets the rays of the packet whose bit in `open` is set meet the instance. Returns the rays that go on.
  std::uint32_t meet_packet(std::uint32_t index, std::uint32_t open, bool any, Hit* hits) {
    const Instance& instance = scene_.instances[index];
    if (is_hidden(instance)) return open;
    std::uint32_t met = 0;
    if (instance.kind == scene::Object::Kind::solid && has_first_crossings(scene_.solids[instance.shape])) {
      met = meet_solid_packet(index, open, any, hits);
    } else if (instance.kind == scene::Object::Kind::group && scene_.trees[instance.shape].is_met_by_octets) {
      met = meet_csg_packet(index, open, any, hits);
    } else if (instance.kind == scene::Object::Kind::blob && Search::takes_packets(scene_.blobs[instance.shape])) {
      met = meet_blob_packet(index, open, any, hits);
    } else {
      met = meet_each(index, open, any, hits);
    }
    if (any) return open & ~met;
    for (; met != 0; met &= met - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(met));
      limits_[i] = last_that_counts(rays_[i], hits[i]);
    }
    return open;
  }

  // The following functions return the rays whose nearest hit is now one of the instance.

  std::uint32_t meet_each(std::uint32_t index, std::uint32_t open, bool any, Hit* hits) {
    std::uint32_t met = 0;
    for (; open != 0; open &= open - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(open));
      undecided_from_ = all_undecided_from_[i];
      if (meet(index, rays_[i], any, hits[i])) met |= 1u << i;
      all_undecided_from_[i] = undecided_from_;
    }
    return met;
  }

  std::uint32_t meet_blob_packet(std::uint32_t index, std::uint32_t open, bool any, Hit* hits) {
    BlobRay blob_rays[kPacket];
    BlobHit blob_hits[kPacket];
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      if ((open >> i & 1) != 0) blob_rays[i] = in_blob(index, rays_[i], any, hits[i]);
    }
    Search::first_hits(scene_.blobs[scene_.instances[index].shape], settings_, memory_, counters_, blob_rays, open,
                       blob_hits);
    std::uint32_t met = 0;
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      if ((open >> i & 1) == 0) continue;
      undecided_from_ = std::min(all_undecided_from_[i], blob_hits[i].undecided_from);
      if (!blob_hits[i].is_miss() && take_blob(index, rays_[i], blob_rays[i], blob_hits[i], hits[i])) met |= 1u << i;
      all_undecided_from_[i] = undecided_from_;
    }
    return met;
  }

  std::uint32_t meet_solid_packet(std::uint32_t index, std::uint32_t open, bool any, Hit* hits) {
    const Instance& instance = scene_.instances[index];
    const OctetRays& rays = octets();
    const OctetMask starts_here = equal(rays.start_instance, Octet(index));
    const FirstCrossings found =
        first_crossings(scene_.solids[instance.shape], scene_.details,
                        instance.is_placed ? mapped(rays.lines, instance.world_from_object.inverse) : rays.lines,
                        select(starts_here, rays.start_part, Octet(-1)));
    const Octet near = rays.nearness(instance.spread, found.t);
    const OctetMask is_crossed = found.t < load(limits_) + near;
    // A crossing so close to the start on another instance may be the face that the ray starts on.
    const OctetMask starts_close = is_crossed & and_not(starts_here, rays.has_start) & (found.t <= near);
    const std::uint32_t alone = bits(found.alone | starts_close) & open;
    std::uint32_t met = alone == 0 ? 0 : meet_each(index, alone, any, hits);
    std::uint32_t crossed = bits(is_crossed) & open & ~alone;
    if (crossed == 0) return met;
    alignas(64) double t[kOctet], part[kOctet];
    store(found.t, t);
    store(found.part, part);
    for (; crossed != 0; crossed &= crossed - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(crossed));
      if (take_solid(index, rays_[i], t[i], static_cast<std::uint8_t>(part[i]), any, hits[i])) met |= 1u << i;
    }
    return met;
  }

  std::uint32_t meet_csg_packet(std::uint32_t index, std::uint32_t open, bool any, Hit* hits) {
    const OctetRays& rays = octets();
    const Octet limits = load(limits_);
    CsgPacket packet(scene_, index, rays);
    const CsgCrossings found = packet.first_hits(limits + rays.nearness(scene_.instances[index].spread, limits), open);
    const std::uint32_t alone = bits(found.alone) & open;
    std::uint32_t met = alone == 0 ? 0 : meet_each(index, alone, any, hits);
    std::uint32_t crossed = bits(found.is_found) & open & ~alone;
    if (crossed == 0) return met;
    alignas(64) double t[kOctet], part[kOctet], leaf[kOctet];
    store(found.t, t);
    store(found.part, part);
    store(found.leaf, leaf);
    const std::uint32_t from_inside = bits(found.from_inside);
    for (; crossed != 0; crossed &= crossed - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(crossed));
      if (!(t[i] < farthest(index, rays_[i], any, hits[i]))) continue;
      const Hit hit{t[i],
                    index,
                    scene::kNone,
                    static_cast<std::uint8_t>(part[i]),
                    (from_inside >> i & 1) != 0,
                    static_cast<std::uint32_t>(leaf[i])};
      if (offer(rays_[i], hit, any, hits[i])) met |= 1u << i;
    }
    return met;
  }

  /// The rays of the present packet side by side.
  const OctetRays& octets() {
    if (!are_octets_loaded_) octets_ = OctetRays(rays_, faces_);
    are_octets_loaded_ = true;
    return octets_;
  }

  [[nodiscard]] bool is_hidden(const Instance& instance) const { return (instance.hidden_from & kind_) != 0; }

  struct Line {
    Vec3 origin, direction;
  };
  /// The ray in the space of an instance.
  [[nodiscard]] static Line in_object(const Instance& instance, const Ray& ray) {
    if (!instance.is_placed) return {ray.origin, ray.direction};
    return {instance.world_from_object.inverse_point(ray.origin),
            instance.world_from_object.inverse_vector(ray.direction)};
  }

  /// The same for an instance that is a blob.
  [[nodiscard]] BlobRay in_blob(std::uint32_t index, const Ray& ray, bool any, const Hit& best) const {
    const Instance& instance = scene_.instances[index];
    const Line line = in_object(instance, ray);
    return {line.origin, line.direction, farthest(index, ray, any, best), ray.start.instance == index,
            any,         ray.path_length};
  }

  /// The farthest t at which an instance's hit can matter: behind the nearest hit, if it may coincide with it and was
  /// declared before.
  [[nodiscard]] double farthest(std::uint32_t index, const Ray& ray, bool any, const Hit& best) const {
    if (any || best.is_miss() || best.instance < index) return best.t;
    return best.t + faces_.nearness(best.instance, ray, best.t) + faces_.nearness(index, ray, best.t);
  }

  /// Takes the hit of a blob, which is no miss. True if it is the nearest. With `any`, its t is rough and within t_max.
  bool take_blob(std::uint32_t index, const Ray& ray, const BlobRay& blob_ray, BlobHit hit, Hit& best) {
    const bool from_elsewhere = ray.start.instance != scene::kNone && ray.start.instance != index;
    if (from_elsewhere && starts_on_blob(index, ray, blob_ray, hit)) {
      BlobRay beyond = blob_ray;
      beyond.starts_on_surface = true;
      beyond.may_go_in = true;
      hit = first_hit(scene_.blobs[scene_.instances[index].shape], beyond);
      if (hit.is_miss()) return false;
    }
    const bool from_inside = hit.from_inside != scene_.instances[index].is_inverse;
    return offer(ray, {hit.t, index, hit.cell, 0, from_inside, scene::kNone}, blob_ray.any, best);
  }

  /// True if the ray's first crossing of a blob is a face that it starts on.
  [[nodiscard]] HWY_NOINLINE bool starts_on_blob(std::uint32_t index, const Ray& ray, const BlobRay& blob_ray,
                                                 BlobHit hit) {
    const CompiledBlob& blob = scene_.blobs[scene_.instances[index].shape];
    if (!blob.grid.box.intersects(blob_ray.origin) && blob.grid.beyond == scene::kNone) return false;
    const double nearest = 2 * faces_.nearness(index, ray, 0);
    if (blob_ray.any) {
      // Its t is rough, so the crossing is searched for close to the start.
      BlobRay near = blob_ray;
      near.any = false;
      near.t_max = std::min(near.t_max, nearest);
      hit = first_hit(blob, near);
    }
    return !hit.is_miss() && hit.t <= nearest &&
           faces_.is_at_start(ray, {hit.t, index, hit.cell, 0, false, scene::kNone});
  }

  /// True if the instance is met before `best`, which then is the new hit.
  bool meet(std::uint32_t index, const Ray& ray, bool any, Hit& best) {
    const Instance& instance = scene_.instances[index];
    if (is_hidden(instance)) return false;
    if (instance.kind == scene::Object::Kind::blob) {
      const BlobRay blob_ray = in_blob(index, ray, any, best);
      const BlobHit hit = first_hit(scene_.blobs[instance.shape], blob_ray);
      return !hit.is_miss() && take_blob(index, ray, blob_ray, hit, best);
    }
    const auto [origin, direction] = in_object(instance, ray);
    const bool starts_here = ray.start.instance == index;
    if (instance.kind == scene::Object::Kind::group) {
      return meet_csg(index, ray, any,
                      {origin, direction, farthest(index, ray, any, best), starts_here ? ray.start.leaf : scene::kNone,
                       ray.start.part, ray.path_length, index, &ray},
                      best);
    }
    const scene::Solid& solid = scene_.solids[instance.shape];
    const std::uint8_t start_part = starts_here ? ray.start.part : kNoPart;
    const Crossings found = crossings_to_first(solid, origin, direction, start_part, scene_.details);
    const std::size_t first = first_ahead(found);
    if (first == static_cast<std::size_t>(found.count)) return false;
    if (!starts_close(index, ray, found.t[first]))
      return take_solid(index, ray, found.t[first], found.part[first], any, best);
    const Crossings all = crossings(solid, origin, direction, start_part, scene_.details);
    const std::size_t behind_start = faces_.pass_start(index, ray, all, first_ahead(all));
    return behind_start != static_cast<std::size_t>(all.count) &&
           take_solid(index, ray, all.t[behind_start], all.part[behind_start], any, best);
  }

  /// The index of the first crossing beyond the start, or their number.
  [[nodiscard]] static std::size_t first_ahead(const Crossings& found) {
    const auto count = static_cast<std::size_t>(found.count);
    std::size_t first = 0;
    while (first < count && !(found.t[first] > 0)) ++first;
    return first;
  }

  /// True if the ray starts on another instance, and so close to a crossing that this may be the face that it starts
  /// on.
  [[nodiscard]] bool starts_close(std::uint32_t index, const Ray& ray, double t) const {
    return ray.start.instance != scene::kNone && ray.start.instance != index && t <= faces_.nearness(index, ray, t);
  }

  /// Takes a crossing of a solid. True if it is the nearest.
  bool take_solid(std::uint32_t index, const Ray& ray, double t, std::uint8_t part, bool any, Hit& best) {
    if (!(t < best.t) && !(t < farthest(index, ray, any, best))) return false;
    const Instance& instance = scene_.instances[index];
    bool from_inside = false;
    if (kind_ == static_cast<std::uint8_t>(RayKind::query) && !any) {
      const Line line = in_object(instance, ray);
      from_inside = is_leaving(scene_.solids[instance.shape], part, line.origin + line.direction * t, line.direction) !=
                    instance.is_inverse;
    }
    return offer(ray, {t, index, scene::kNone, part, from_inside, scene::kNone}, any, best);
  }

  bool meet_csg(std::uint32_t index, const Ray& ray, bool any, const CsgRay& csg_ray, Hit& best) {
    const Instance& instance = scene_.instances[index];
    const BlobSearch blobs{this, [](void* self, std::uint32_t blob, const BlobRay& blob_ray) {
                             auto& world = *static_cast<WorldTrace*>(self);
                             return world.first_hit(world.scene_.blobs[blob], blob_ray);
                           }};
    const CsgTree& tree = scene_.trees[instance.shape];
    if (!meets_bounds(tree, csg_ray)) return false;
    memory_.csg.entries.clear();
    if (!tree.boxes.is_empty()) {
      walk_boxes(tree.boxes, csg_ray.origin, csg_ray.direction, csg_ray.t_max,
                 [&](std::uint32_t leaf, double enter) HWY_ATTR {
                   memory_.csg.entries.push_back({enter, leaf});
                   return csg_ray.t_max;
                 });
    }
    const CsgHit hit = first_csg_hit(scene_, tree, csg_ray, faces_, blobs, memory_.csg);
    if (hit.is_miss()) return false;
    return offer(ray, {hit.t, index, hit.cell, hit.part, hit.from_inside, hit.leaf}, any, best);
  }

  /// Makes a hit the best if it is the nearest. The farther of the two is kept if it was declared before and may
  /// coincide.
  bool offer(const Ray& ray, const Hit& hit, bool any, Hit& best) {
    if (any) {
      best = hit;
      return true;
    }
    const bool is_nearer = hit.t < best.t;
    if (!best.is_miss() && (hit.instance < best.instance) != is_nearer) {
      faces_.keep_if_near(ray, is_nearer ? hit : best, is_nearer ? best : hit);
    }
    if (is_nearer) best = hit;
    return is_nearer;
  }

  /// The farthest t at which a hit behind the nearest one must still be looked at.
  [[nodiscard]] double last_that_counts(const Ray& ray, const Hit& best) const {
    return best.is_miss() ? best.t : best.t + 2 * faces_.nearness(best.instance, ray, best.t);
  }

  [[nodiscard]] BlobGradient blob_gradient() {
    return {this, [](void* self, std::uint32_t blob, std::uint32_t cell, const Vec3& point) {
              auto& world = *static_cast<WorldTrace*>(self);
              if (is_published(world.settings_.name)) return Vec3(0);
              const ShareRule rule{&world.scene_.coordinate_textures, scene::kNoTexture};
              blob_point(world.scene_.blobs[blob], cell, point, rule, world.memory_.point);
              return world.memory_.point.gradient;
            }};
  }

  [[nodiscard]] bool is_leaving(const scene::Solid& solid, std::uint8_t part, const Vec3& point,
                                const Vec3& direction) const {
    return normal_at(solid, part, point, scene_.details).dot(direction) > 0;
  }

  [[nodiscard]] BlobHit first_hit(const CompiledBlob& blob, const BlobRay& ray) {
    const BlobHit hit = Search::first_hit(blob, settings_, memory_, counters_, ray);
    undecided_from_ = std::min(undecided_from_, hit.undecided_from);
    return hit;
  }

  /// An answer is undecided if the ray was, before its hit.
  static void judge(Hit& hit, double undecided_from) {
    if (undecided_from <= hit.t && undecided_from < std::numeric_limits<double>::infinity())
      hit.certainty = Certainty::undecided;
  }

  const CompiledScene& scene_;
  const SolverSettings& settings_;
  TraceMemory& memory_;
  TraceCounters& counters_;
  double undecided_from_ = 0;                         ///< the least t at which the present ray was undecided
  std::array<double, kPacket> all_undecided_from_{};  ///< the same for the rays of a packet
  std::uint8_t kind_;                                 ///< the bits of a RayKind, kOnlyOpaque and kOnlyClear
  RayFaces faces_;
  // These members belong to the present packet.
  std::span<const Ray> rays_;
  OctetRays octets_;  ///< the rays, if are_octets_loaded_
  bool are_octets_loaded_ = false;
  alignas(64) double limits_[kOctet] = {};  ///< the farthest t at which hits of each ray must still be looked at
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
