// One ray against the whole scene: listed instances first, then those in the hierarchy of boxes, nearest boxes first,
// each in its own space. t is the same in all spaces, since directions are transformed and not normalised again.
//
// Hits that coincide are resolved by trace/ray_faces.h. It is asked only about crossings close to the start or to one
// another.
#if defined(ISL_RENDERER_TRACE_SINGLE_TRACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_TRACE_SINGLE_TRACE_INL_H_
#undef ISL_RENDERER_TRACE_SINGLE_TRACE_INL_H_
#else
#define ISL_RENDERER_TRACE_SINGLE_TRACE_INL_H_
#endif

#include "renderer/boxes/box_walk-inl.h"
#include "renderer/compiled/blob_point-inl.h"
#include "renderer/rays/blob_ray.h"
#include "renderer/solids/solid.h"
#include "renderer/trace/ray_faces.h"
#include "renderer/trace/trace_entry_points.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// `Search` has
///   BlobHit first_hit(const CompiledBlob&, const SolverSettings&, TraceMemory&, TraceCounters&, const BlobRay&).
template <class Search>
class SingleTrace {
 public:
  SingleTrace(const CompiledScene& scene, const SolverSettings& settings, RayKind kind, TraceMemory& memory,
              TraceCounters& counters)
      : scene_(scene),
        settings_(settings),
        memory_(memory),
        counters_(counters),
        kind_(static_cast<std::uint8_t>(kind)),
        faces_(scene, blob_gradient(), memory.coinciding != nullptr) {}

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
      best = settle(ray, best);
      faces_.forget();
    }
    judge(best, undecided_from_);
    return best;
  }

  // PacketTrace (packet_trace-inl.h) uses the following functions for rays that it traces alone.

  /// The hit that shows, of those at the place of the nearest one. If all are wanted, they are listed.
  [[nodiscard]] Hit settle(const Ray& ray, const Hit& nearest) {
    if (faces_.keeps_all() && !nearest.is_miss()) list_coinciding(ray, nearest);
    return faces_.first_declared(ray, nearest);
  }

  [[nodiscard]] bool is_hidden(const Instance& instance) const { return (instance.hidden_from & kind_) != 0; }

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
                       ray.start.part, ray.path_length, index, &ray, faces_.keeps_all() && !any},
                      best);
    }
    const scene::Solid& solid = scene_.solids[instance.shape];
    const std::uint32_t start_part = starts_here ? ray.start.part : kNoPart;
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

  /// The ray as a blob meets it.
  [[nodiscard]] BlobRay in_blob(std::uint32_t index, const Ray& ray, bool any, const Hit& best) const {
    const Instance& instance = scene_.instances[index];
    const Line line = in_object(instance, ray);
    const bool starts_here = ray.start.instance == index;
    return {.origin = line.origin,
            .direction = line.direction,
            .t_max = farthest(index, ray, any, best),
            .starts_on_surface = starts_here,
            .any = any,
            .path_length = ray.path_length,
            .takes_faint_dips = !is_query() && !starts_here};
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

  /// The farthest t at which a hit behind the nearest one must still be looked at.
  [[nodiscard]] double last_that_counts(const Ray& ray, const Hit& best) const {
    return best.is_miss() ? best.t : best.t + 2 * faces_.nearness(best.instance, ray, best.t);
  }

  [[nodiscard]] RayFaces& faces() { return faces_; }
  /// The least t at which the present ray was undecided.
  [[nodiscard]] double undecided_from() const { return undecided_from_; }
  void set_undecided_from(double t) { undecided_from_ = t; }
  [[nodiscard]] bool is_query() const { return kind_ == static_cast<std::uint8_t>(RayKind::query); }

  /// An answer is undecided if the ray was, before its hit.
  static void judge(Hit& hit, double undecided_from) {
    if (undecided_from <= hit.t && undecided_from < std::numeric_limits<double>::infinity())
      hit.certainty = Certainty::undecided;
  }

 private:
  static constexpr double kEnd = -1;

  [[nodiscard]] static bool is_sound(const Ray& ray) {
    const double sum = ray.origin.x + ray.origin.y + ray.origin.z + ray.direction.x + ray.direction.y + ray.direction.z;
    return std::isfinite(sum) && ray.direction.length2() > 0;
  }

  struct Line {
    Vec3 origin, direction;
  };
  /// The ray in the space of an instance.
  [[nodiscard]] static Line in_object(const Instance& instance, const Ray& ray) {
    if (!instance.is_placed) return {ray.origin, ray.direction};
    return {instance.world_from_object.inverse_point(ray.origin),
            instance.world_from_object.inverse_vector(ray.direction)};
  }

  /// The farthest t at which an instance's hit can matter: behind the nearest hit, if it may coincide with it, and was
  /// declared before or is wanted anyway.
  [[nodiscard]] double farthest(std::uint32_t index, const Ray& ray, bool any, const Hit& best) const {
    if (any || best.is_miss() || (best.instance < index && !faces_.keeps_all())) return best.t;
    return best.t + faces_.nearness(best.instance, ray, best.t) + faces_.nearness(index, ray, best.t);
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
  bool take_solid(std::uint32_t index, const Ray& ray, double t, std::uint32_t part, bool any, Hit& best) {
    if (!(t < best.t) && !(t < farthest(index, ray, any, best))) return false;
    const Instance& instance = scene_.instances[index];
    bool from_inside = false;
    if (is_query() && !any) {
      const Line line = in_object(instance, ray);
      from_inside = is_leaving(scene_.solids[instance.shape], part, line.origin + line.direction * t, line.direction) !=
                    instance.is_inverse;
    }
    return offer(ray, {t, index, scene::kNone, part, from_inside, scene::kNone}, any, best);
  }

  bool meet_csg(std::uint32_t index, const Ray& ray, bool any, const CsgRay& csg_ray, Hit& best) {
    const Instance& instance = scene_.instances[index];
    const BlobSearch blobs{this, [](void* self, std::uint32_t blob, const BlobRay& blob_ray) {
                             auto& world = *static_cast<SingleTrace*>(self);
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
    memory_.csg.seen.clear();
    const CsgHit first = first_csg_hit(scene_, tree, csg_ray, faces_, blobs, memory_.csg);
    if (first.is_miss()) return false;
    const auto in_world = [index](const CsgHit& hit) {
      return Hit{hit.t, index, hit.cell, hit.part, hit.from_inside, hit.leaf};
    };
    const bool is_nearest = offer(ray, in_world(first), any, best);
    if (csg_ray.wants_all) {
      for (std::size_t i = 1; i < memory_.csg.seen.size(); ++i)
        faces_.keep_if_near(ray, best, in_world(memory_.csg.seen[i]));
    }
    return is_nearest;
  }

  /// Lists the faces that the ray crosses where it meets the nearest one (Tracer::first_hits). Where something opaque
  /// is among them, the nearest alone is seen, as in POV-Ray: a glass that stands on a table is in contact with it, and
  /// does not mirror there.
  HWY_NOINLINE void list_coinciding(const Ray& ray, const Hit& nearest) {
    std::vector<Hit> faces = faces_.coinciding(ray, nearest);
    const auto is_clear = [&](const Hit& face) {
      return (scene_.instances[face.instance].hidden_from & kOnlyOpaque) != 0;
    };
    if (faces.size() == 1 || !std::ranges::all_of(faces, is_clear)) return;
    std::erase_if(faces, [&](const Hit& face) { return !crosses(ray, face); });
    for (const Hit& face : faces) memory_.coinciding->push_back({&ray, face});
  }
  /// False if the ray crosses the surface of the hit's object once more at the place of the hit, so that it is on the
  /// same side before and behind.
  [[nodiscard]] bool crosses(const Ray& ray, const Hit& hit) {
    const double undecided_from = undecided_from_;
    bool crosses = true;
    Ray beyond = continued(ray, hit);
    for (;; crosses = !crosses) {
      Hit next;
      next.t = 2 * faces_.nearness(hit.instance, beyond, 0);
      if (!meet(hit.instance, beyond, false, next) || !faces_.is_at_start(beyond, next)) break;
      beyond = continued(beyond, next);
      faces_.forget_reach();
    }
    faces_.forget_reach();
    undecided_from_ = undecided_from;
    return crosses;
  }

  /// Makes a hit the best if it is the nearest. The farther of the two is kept if it may coincide, and was declared
  /// before or is wanted anyway.
  bool offer(const Ray& ray, const Hit& hit, bool any, Hit& best) {
    if (any) {
      best = hit;
      return true;
    }
    const bool is_nearer = hit.t < best.t;
    if (!best.is_miss() && (faces_.keeps_all() || (hit.instance < best.instance) != is_nearer)) {
      faces_.keep_if_near(ray, is_nearer ? hit : best, is_nearer ? best : hit);
    }
    if (is_nearer) best = hit;
    return is_nearer;
  }

  [[nodiscard]] BlobGradient blob_gradient() {
    return {this, [](void* self, std::uint32_t blob, std::uint32_t cell, const Vec3& point) {
              auto& world = *static_cast<SingleTrace*>(self);
              if (is_published(world.settings_.name)) return Vec3(0);
              const ShareRule rule{&world.scene_.coordinate_textures, scene::kNoTexture};
              blob_point(world.scene_.blobs[blob], cell, point, rule, world.memory_.point);
              return world.memory_.point.fields.gradient;
            }};
  }

  [[nodiscard]] bool is_leaving(const scene::Solid& solid, std::uint32_t part, const Vec3& point,
                                const Vec3& direction) const {
    return normal_at(solid, part, point, scene_.details).dot(direction) > 0;
  }

  [[nodiscard]] BlobHit first_hit(const CompiledBlob& blob, const BlobRay& ray) {
    const BlobHit hit = Search::first_hit(blob, settings_, memory_, counters_, ray);
    undecided_from_ = std::min(undecided_from_, hit.undecided_from);
    return hit;
  }

  const CompiledScene& scene_;
  const SolverSettings& settings_;
  TraceMemory& memory_;
  TraceCounters& counters_;
  double undecided_from_ = 0;  ///< the least t at which the present ray was undecided
  std::uint8_t kind_;          ///< the bits of a RayKind, kOnlyOpaque and kOnlyClear
  RayFaces faces_;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
