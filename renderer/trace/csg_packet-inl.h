// The first surface of a small combination of solids along eight rays at once (CsgTree::is_met_by_octets).
//
// Each leaf is inside on one stretch of a ray, or on two if it is of order 3 or 4, so the state of all leaves at any t
// follows from the ends of their stretches, and no crossing waits for another. A crossing shows if the other leaves are
// as CsgState::shows() asks. The nearest one that shows is the hit.
//
// Crossings of several leaves that are closer than their rounding are taken together by csg_search.h, as are those near
// the ray's start. Rays that have such crossings before their hit are left to it. If crossings at one place change the
// whole together, each of them is close to another, so no such hit is lost here.
#if defined(ISL_RENDERER_TRACE_CSG_PACKET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_TRACE_CSG_PACKET_INL_H_
#undef ISL_RENDERER_TRACE_CSG_PACKET_INL_H_
#else
#define ISL_RENDERER_TRACE_CSG_PACKET_INL_H_
#endif

#include "renderer/compiled/compiled_scene.h"
#include "renderer/solids/octet_intervals-inl.h"
#include "renderer/solids/octet_solids.h"
#include "renderer/solids/roots_of_solid-inl.h"
#include "renderer/trace/octet_hits-inl.h"
#include "renderer/trace/octet_rays-inl.h"

#include <algorithm>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class CsgPacket {
 public:
  /// `index` is the number of the instance as which the tree is met. Hits are wanted of the rays with a bit in `open`,
  /// before `limit`.
  CsgPacket(const CompiledScene& scene, std::uint32_t index, const OctetLines& world_lines, const OctetStarts& starts,
            const Octet& limit, std::uint32_t open)
      : instance_(scene.instances[index]),
        tree_(scene.trees[instance_.shape]),
        starts_(starts),
        limit_(limit),
        is_open_(mask_of(open)) {
    // A crossing that lies no farther than this behind the limit may coincide with one before it.
    wanted_to_ = keep(is_open_, limit + Octet(8.0) * starts.nearness(instance_.spread, limit));
    const OctetLines lines =
        instance_.is_placed ? mapped(world_lines, instance_.world_from_object.inverse) : world_lines;
    const OctetMask starts_here = equal(starts.instance, Octet(index));
    const Octet nowhere(-1);
    const Octet start_leaf = select(starts_here, starts.leaf, nowhere);
    alone_ = no_lane();
    for (std::uint32_t i = 0; i < tree_.leaves.size(); ++i) {
      const CsgLeaf& leaf = tree_.leaves[i];
      Leaf& own = leaves_[i];
      own.starts_here = equal(start_leaf, Octet(i));
      const scene::Solid& solid = scene.solids[leaf.shape];
      const OctetLines own_lines = leaf.is_placed ? mapped(lines, leaf.group_from_leaf.inverse) : lines;
      const Octet start_part = select(own.starts_here, starts.part, nowhere);
      own.count = 0;
      if (has_octet_roots(solid)) {
        const OctetRoots roots = roots_of_solid(solid, scene.details, own_lines, start_part,
                                                stretch_in(leaf.box, lines, own.starts_here), OctetRoots::kMost);
        const OctetStretches stretches = stretches_of(roots, alone_);
        own.add(stretches.first);
        own.add(stretches.second);
      } else {
        own.add(inside_of(solid, scene.details, own_lines, start_part, alone_));
      }
    }
  }

  /// The first hit of each ray; t is the limit where there is none. Rays that are not open may get any answer.
  [[nodiscard]] OctetCrossings first_hits() {
    best_.t = limit_;
    best_.leaf = best_.part = Octet(0.0);
    best_.is_there = best_.from_inside = no_lane();
    first_close_ = Octet(kInfinity);
    for (std::uint32_t i = 0; i < tree_.leaves.size(); ++i) {
      for (const OctetIntervals& inside : leaves_[i].stretches()) {
        cross(i, inside.low, inside.low_part, tree_.leaves[i].is_inverse);
        cross(i, inside.high, inside.high_part, !tree_.leaves[i].is_inverse);
      }
    }
    best_.alone = alone_ | ((first_close_ <= best_.t) & (first_close_ < Octet(kInfinity)));
    return best_;
  }

 private:
  /// As CsgSearch::stretch_of(); empty where a line misses the box.
  [[nodiscard]] OctetStretch stretch_in(const Box& box, const OctetLines& lines, const OctetMask& starts_here) const {
    const Octet* const origin[] = {&lines.origin.x, &lines.origin.y, &lines.origin.z};
    const Octet* const direction[] = {&lines.direction.x, &lines.direction.y, &lines.direction.z};
    const Octet zero(0.0);
    OctetStretch stretch{zero, Octet(kInfinity), wanted_to_};
    OctetMask misses = no_lane();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto axis = static_cast<int>(i);
      const Octet least(box.min[axis]), greatest(box.max[axis]);
      const Octet a = (least - *origin[i]) / *direction[i], b = (greatest - *origin[i]) / *direction[i];
      const OctetMask is_flat = equal(*direction[i], zero);
      misses = misses | and_not((*origin[i] >= least) & (*origin[i] <= greatest), is_flat);
      stretch.from = select(is_flat, stretch.from, max(stretch.from, min(a, b)));
      stretch.to = select(is_flat, stretch.to, min(stretch.to, max(a, b)));
    }
    misses = misses | and_not(stretch.from <= stretch.to, all_lanes());
    const auto nearness = [&](const Octet& t) HWY_ATTR { return starts_.nearness(instance_.spread, t); };
    const OctetMask begins_at_start = starts_here | (stretch.from <= zero);
    const Octet from = select(begins_at_start, zero, stretch.from - nearness(stretch.from));
    return {select(misses, zero, from), select(misses, zero, stretch.to + nearness(stretch.to)), wanted_to_};
  }

  struct Leaf {
    OctetIntervals inside[2];  ///< from ∞ to −∞ where a ray misses the leaf
    std::size_t count;         ///< of them; others are not met by any ray ahead of its start
    OctetMask starts_here;

    HWY_INLINE void add(OctetIntervals stretch) {
      const OctetMask is_met = stretch.low < stretch.high;
      stretch.low = select(is_met, stretch.low, Octet(kInfinity));
      stretch.high = select(is_met, stretch.high, Octet(-kInfinity));
      if (!none(is_met & (stretch.high > Octet(0.0)))) inside[count++] = stretch;
    }
    [[nodiscard]] std::span<const OctetIntervals> stretches() const { return {inside, count}; }
  };

  /// Takes the crossings of a leaf at t.
  void cross(std::uint32_t index, const Octet& t, const Octet& part, bool from_inside) {
    const OctetMask ahead = is_open_ & (t > Octet(0.0)) & (t < best_.t);
    if (none(ahead)) return;
    const Leaf& own = leaves_[index];
    const Octet near = starts_.nearness(instance_.spread, t);
    alone_ = alone_ | (and_not(own.starts_here, ahead & starts_.is_known) & (t <= near));
    // csg_search.h compares with twice the rounding at the later of two crossings, which is less than this.
    const Octet close = Octet(4.0) * near;
    OctetMask is_close = no_lane();
    for (const OctetIntervals& inside : own.stretches()) {
      is_close = is_close | ((inside.high - inside.low) <= close);
      // The gap between its two stretches may be as short.
      if (own.count > 1)
        is_close = is_close | and_not(equal(inside.low, t), abs(inside.low - t) <= close) |
                   and_not(equal(inside.high, t), abs(inside.high - t) <= close);
    }
    const OctetMask shows = shows_at(index, t, close, is_close);
    first_close_ = min(first_close_, select(ahead & is_close, t, Octet(kInfinity)));
    if (!tree_.leaves[index].is_seen) return;
    const OctetMask found = ahead & shows;
    best_.t = select(found, t, best_.t);
    best_.leaf = select(found, Octet(index), best_.leaf);
    best_.part = select(found, part, best_.part);
    best_.is_there = best_.is_there | found;
    best_.from_inside = from_inside ? best_.from_inside | found : and_not(found, best_.from_inside);
  }

  /// As CsgState::shows(): the states of all leaves but one, at t, decide. Lanes where another leaf is crossed within
  /// `close` of t are added to `is_close`.
  [[nodiscard]] OctetMask shows_at(std::uint32_t index, const Octet& t, const Octet& close, OctetMask& is_close) {
    const Octet zero(0.0);
    const std::size_t nodes = tree_.nodes.size();
    bool is_above[kMostOctetNodes] = {};
    for (std::uint32_t node = tree_.leaves[index].parent; node != scene::kNone; node = tree_.nodes[node].parent) {
      is_above[node] = true;
    }
    // For an `all`, holds[node] tells that all its children hold; for any other node, that some child does. At nodes
    // above the leaf only the other children count.
    OctetMask holds[kMostOctetNodes];
    for (std::size_t node = 0; node < nodes; ++node) {
      holds[node] = tree_.nodes[node].kind == CsgNode::Kind::all ? all_lanes() : no_lane();
    }
    for (std::uint32_t i = 0; i < tree_.leaves.size(); ++i) {
      if (i == index) continue;
      const CsgLeaf& leaf = tree_.leaves[i];
      OctetMask is_inside = no_lane();
      for (const OctetIntervals& inside : leaves_[i].stretches()) {
        const Octet to_low = inside.low - t, to_high = inside.high - t;
        is_inside = is_inside | ((to_low < zero) & (to_high > zero));
        is_close = is_close | (min(abs(to_low), abs(to_high)) <= close);
      }
      add(leaf.is_inverse ? and_not(is_inside, all_lanes()) : is_inside, leaf.parent, holds);
    }
    // Children come after their parents.
    for (std::size_t node = nodes; node-- > 1;) {
      if (!is_above[node]) add(holds[node], tree_.nodes[node].parent, holds);
    }
    OctetMask shows = all_lanes();
    for (std::uint32_t node = tree_.leaves[index].parent; node != scene::kNone; node = tree_.nodes[node].parent) {
      if (tree_.nodes[node].kind == CsgNode::Kind::all) shows = shows & holds[node];
      if (tree_.nodes[node].kind == CsgNode::Kind::merge) shows = and_not(holds[node], shows);
    }
    return shows;
  }

  HWY_INLINE void add(const OctetMask& child, std::uint32_t node, OctetMask* holds) const {
    holds[node] = tree_.nodes[node].kind == CsgNode::Kind::all ? holds[node] & child : holds[node] | child;
  }

  const Instance& instance_;
  const CsgTree& tree_;
  const OctetStarts& starts_;
  Octet limit_;
  OctetMask is_open_;
  Octet wanted_to_;  ///< the end of the crossings that may matter
  Leaf leaves_[kMostOctetLeaves];
  OctetMask alone_;
  Octet first_close_;  ///< the nearest crossing that is close to another
  OctetCrossings best_;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
