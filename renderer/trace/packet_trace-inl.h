// Eight rays at once against the whole scene, in the order of single_trace-inl.h: each instance is met by all of them.
// Solids, small combinations and blobs have loops for eight rays. Whatever else a ray meets, and crossings that may
// coincide with others or with the start, are for single rays.
#if defined(ISL_RENDERER_TRACE_PACKET_TRACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_TRACE_PACKET_TRACE_INL_H_
#undef ISL_RENDERER_TRACE_PACKET_TRACE_INL_H_
#else
#define ISL_RENDERER_TRACE_PACKET_TRACE_INL_H_
#endif

#include "renderer/boxes/box_walk-inl.h"
#include "renderer/solids/first_crossings-inl.h"
#include "renderer/trace/csg_packet-inl.h"
#include "renderer/trace/octet_hits-inl.h"
#include "renderer/trace/octet_rays-inl.h"
#include "renderer/trace/single_trace-inl.h"

#include <array>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// `Search` has, besides what SingleTrace asks for,
///   bool takes_packets(const CompiledBlob&)
///   void first_hits(const CompiledBlob&, const SolverSettings&, TraceMemory&, TraceCounters&, const OctetBlobRays&,
///                   std::uint32_t rays, OctetBlobHits&).
template <class Search>
class PacketTrace {
 public:
  PacketTrace(const CompiledScene& scene, const SolverSettings& settings, RayKind kind, TraceMemory& memory,
              TraceCounters& counters)
      : scene_(scene),
        settings_(settings),
        memory_(memory),
        counters_(counters),
        single_(scene, settings, kind, memory, counters) {}

  /// The first hits of up to kPacket rays.
  void first_hits(std::span<const Ray> rays, Hit* hits) {
    trace(rays, false);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      hits[i] = hits_[i];
      if (hits[i].is_miss()) hits[i].t = std::numeric_limits<double>::infinity();
    }
    if (single_.faces().has_kept()) {
      for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = single_.settle(rays[i], hits[i]);
      single_.faces().forget();
    }
    if (!is_some_undecided_) return;
    for (std::size_t i = 0; i < rays.size(); ++i) SingleTrace<Search>::judge(hits[i], undecided_from_[i]);
  }

  /// Sets occluded[i] to an Occlusion, which tells whether rays[i] meets anything. There are at most kPacket rays.
  void occlusions(std::span<const Ray> rays, std::uint8_t* occluded) {
    const std::uint32_t open = trace(rays, true);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      Hit none;
      SingleTrace<Search>::judge(none, undecided_from_[i]);
      occluded[i] = (open >> i & 1) != 0 ? occlusion_of(none) : kOccluded;
    }
  }

 private:
  /// With `any`, returns the rays that meet nothing.
  std::uint32_t trace(std::span<const Ray> rays, bool any) {
    rays_ = rays;
    any_ = any;
    octets_ = OctetRays(rays);
    are_starts_known_ = false;
    hits_.start(octets_.t_max);
    undecided_from_.fill(std::numeric_limits<double>::infinity());
    is_some_undecided_ = false;
    const std::uint32_t unsound = ~bits(octets_.are_sound());
    std::uint32_t open = ~unsound & ((1u << rays.size()) - 1);
    for (const std::uint32_t instance : scene_.listed) open = meet(instance, open);
    if (open != 0 && !scene_.boxes.is_empty()) {
      const auto& [o, d] = octets_.lines;
      open = walk_boxes(scene_.boxes, BoxRays({o.x, o.y, o.z}, {d.x, d.y, d.z}, open), hits_.limits(), open,
                        [&](std::uint32_t instance, std::uint32_t met) HWY_ATTR { return meet(instance, met); });
    }
    return open | unsound;
  }

  /// Lets the rays of the packet whose bit in `open` is set meet the instance. Returns the rays that go on.
  std::uint32_t meet(std::uint32_t index, std::uint32_t open) {
    const Instance& instance = scene_.instances[index];
    if (single_.is_hidden(instance)) return open;
    std::uint32_t met = 0;
    if (instance.kind == scene::Object::Kind::solid && has_first_crossings(scene_.solids[instance.shape])) {
      met = meet_solid(index, open);
    } else if (instance.kind == scene::Object::Kind::group && scene_.trees[instance.shape].is_met_by_octets) {
      met = meet_csg(index, open);
    } else if (instance.kind == scene::Object::Kind::blob && Search::takes_packets(scene_.blobs[instance.shape])) {
      met = meet_blob(index, open);
    } else {
      met = meet_each(index, open);
    }
    return any_ ? open & ~met : open;
  }

  // The following functions return the rays whose nearest hit is now one of the instance.

  std::uint32_t meet_each(std::uint32_t index, std::uint32_t open) {
    std::uint32_t met = 0;
    for (; open != 0; open &= open - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(open));
      Hit best = hits_[i];
      single_.set_undecided_from(undecided_from_[i]);
      if (single_.meet(index, rays_[i], any_, best)) {
        met |= 1u << i;
        set(i, best);
      }
      note_undecided(i);
    }
    return met;
  }

  std::uint32_t meet_blob(std::uint32_t index, std::uint32_t open) {
    const Instance& instance = scene_.instances[index];
    std::uint32_t start_here = 0, start_elsewhere = 0;
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      const InstanceId start = rays_[i].start.instance;
      start_here |= std::uint32_t{start == index} << i;
      start_elsewhere |= std::uint32_t{start != index && start != scene::kNone} << i;
    }
    OctetBlobRays rays;
    rays.lines = instance.is_placed ? mapped(octets_.lines, instance.world_from_object.inverse) : octets_.lines;
    rays.t_max = farthest(index);
    rays.path_length = octets_.path_length;
    rays.start_on_surface = start_here;
    rays.take_faint_dips = single_.is_query() ? 0 : ~start_here;
    rays.any = any_;
    OctetBlobHits hits;
    Search::first_hits(scene_.blobs[instance.shape], settings_, memory_, counters_, rays, open, hits);
    // Single rays judge faces that may coincide with the start or with the nearest hit so far, and what is undecided.
    std::uint32_t unlike = any_ ? 0 : bits(hits_.are_met()) & hits.found;
    if (const std::uint32_t from_elsewhere = start_elsewhere & hits.found; from_elsewhere != 0) {
      const Octet nearest = Octet(2.0) * starts().nearness(instance.spread, Octet(0.0));
      unlike |= from_elsewhere & bits(load(hits.t) <= nearest);
    }
    const std::uint32_t alone = (unlike | hits.undecided) & open;
    std::uint32_t met = hits.found & open & ~alone;
    if (met != 0 && !any_) {
      OctetCrossings found;
      found.t = load(hits.t);
      found.part = Octet(0.0);
      found.cell = load(hits.cell);
      found.from_inside = mask_of(hits.from_inside ^ (instance.is_inverse ? 0xff : 0));
      const OctetMask nearer = (found.t < hits_.t()) & mask_of(met);
      met = bits(nearer);
      hits_.take(nearer, index, instance.spread, found,
                 found.t + Octet(2.0) * starts().nearness(instance.spread, found.t));
    }
    for (std::uint32_t left = alone; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      const BlobHit hit = hits[i];
      single_.set_undecided_from(std::min(undecided_from_[i], hit.undecided_from));
      if (!hit.is_miss()) {
        Hit best = hits_[i];
        if (single_.take_blob(index, rays_[i], rays[i], hit, best)) {
          met |= 1u << i;
          set(i, best);
        }
      }
      note_undecided(i);
    }
    return met;
  }

  /// SingleTrace::farthest of each ray.
  [[nodiscard]] Octet farthest(std::uint32_t index) {
    const Octet t = hits_.t();
    if (any_) return t;
    OctetMask may_coincide = hits_.are_met();
    if (!single_.faces().keeps_all()) may_coincide = may_coincide & (Octet(index) < hits_.instance());
    if (none(may_coincide)) return t;
    const Octet near = starts().nearness(hits_.factor(), hits_.size(), t);
    return select(may_coincide, t + near + starts().nearness(scene_.instances[index].spread, t), t);
  }

  std::uint32_t meet_solid(std::uint32_t index, std::uint32_t open) {
    const Instance& instance = scene_.instances[index];
    const OctetMask starts_here = equal(starts().instance, Octet(index));
    const FirstCrossings first =
        first_crossings(scene_.solids[instance.shape], scene_.details,
                        instance.is_placed ? mapped(octets_.lines, instance.world_from_object.inverse) : octets_.lines,
                        select(starts_here, starts().part, Octet(-1)));
    const Octet near = starts().nearness(instance.spread, first.t);
    OctetCrossings found;
    found.t = first.t;
    found.part = first.part;
    found.is_there = first.t < load(hits_.limits()) + near;
    // A crossing so close to the start on another instance may be the face that the ray starts on.
    const OctetMask starts_close = found.is_there & and_not(starts_here, starts().is_known) & (found.t <= near);
    found.alone = first.alone | starts_close;
    if (single_.is_query()) found.alone = found.alone | found.is_there;  // they ask for Hit::from_inside
    return take(index, found, near, open);
  }

  std::uint32_t meet_csg(std::uint32_t index, std::uint32_t open) {
    const Octet limits = load(hits_.limits());
    const Octet end = limits + starts().nearness(scene_.instances[index].spread, limits);
    const OctetCrossings found = CsgPacket(scene_, index, octets_.lines, starts(), end, open).first_hits();
    return take(index, found, starts().nearness(scene_.instances[index].spread, found.t), open);
  }

  /// Takes the crossings of an instance, which are `near` to whatever lies closer than this. Those that may coincide
  /// with the nearest hit so far are for single rays.
  std::uint32_t take(std::uint32_t index, const OctetCrossings& found, const Octet& near, std::uint32_t open) {
    const Octet best = hits_.t();
    OctetMask nearer = found.is_there & (found.t < best);
    OctetMask alone = found.alone;
    if (!any_) {
      const OctetMask earlier = Octet(index) < hits_.instance();
      const Octet apart = Octet(2.0) * (near + starts().nearness(hits_.factor(), hits_.size(), best));
      OctetMask coincides = found.is_there & hits_.are_met() & (abs(found.t - best) <= apart);
      if (!single_.faces().keeps_all()) coincides = and_not(nearer & earlier, coincides & (nearer | earlier));
      alone = alone | coincides;
    }
    std::uint32_t met = bits(nearer) & open;
    if (const std::uint32_t lone = bits(alone) & open; lone != 0) [[unlikely]] {
      met = (met & ~lone) | meet_each(index, lone);
      nearer = mask_of(met & ~lone);
    } else if (met != 0) {
      nearer = nearer & mask_of(open);
    }
    if (!any_ && met != 0)
      hits_.take(nearer, index, scene_.instances[index].spread, found, found.t + Octet(2.0) * near);
    return met;
  }

  [[nodiscard]] const OctetStarts& starts() {
    if (!are_starts_known_) [[unlikely]]
      starts_ = OctetStarts(rays_, octets_, single_.faces());
    are_starts_known_ = true;
    return starts_;
  }

  /// The hit is the nearest one of the ray so far.
  void set(std::size_t i, const Hit& hit) {
    if (any_) return;
    hits_.set(i, hit, scene_.instances[hit.instance].spread, single_.last_that_counts(rays_[i], hit));
  }

  /// Keeps what the present ray, number i, says of its certainty.
  void note_undecided(std::size_t i) {
    undecided_from_[i] = single_.undecided_from();
    is_some_undecided_ |= undecided_from_[i] < std::numeric_limits<double>::infinity();
  }

  const CompiledScene& scene_;
  const SolverSettings& settings_;
  TraceMemory& memory_;
  TraceCounters& counters_;
  SingleTrace<Search> single_;
  // These members belong to the present packet.
  std::span<const Ray> rays_;
  bool any_ = false;  ///< any hit will do
  OctetRays octets_;
  OctetStarts starts_;  ///< if are_starts_known_
  bool are_starts_known_ = false;
  OctetHits hits_;
  std::array<double, kPacket> undecided_from_{};  ///< the least t at which each ray was undecided
  bool is_some_undecided_ = false;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
