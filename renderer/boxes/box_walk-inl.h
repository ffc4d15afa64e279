// Rays through a hierarchy of boxes, nearest boxes first: one ray, which meets the eight children of a node at once, or
// eight rays, which meet one child after the other at once.
#if defined(ISL_RENDERER_BOXES_BOX_WALK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_BOXES_BOX_WALK_INL_H_
#undef ISL_RENDERER_BOXES_BOX_WALK_INL_H_
#else
#define ISL_RENDERER_BOXES_BOX_WALK_INL_H_
#endif

#include "renderer/boxes/box_test.h"
#include "renderer/boxes/box_tree.h"
#include "renderer/simd/octet-inl.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// What is left to visit, with the farthest on top of the nearest so that the nearest is taken first.
template <class Entry>
class BoxStack {
 public:
  [[nodiscard]] HWY_INLINE bool is_empty() const { return size_ == 0; }
  HWY_INLINE Entry pop() { return entries_[--size_]; }
  /// Begins the children of a node.
  HWY_INLINE void begin() { first_ = size_; }
  /// Adds a child; those of the node stay sorted.
  HWY_INLINE void push(const Entry& entry) {
    std::size_t at = size_++;
    for (; at > first_ && entries_[at - 1].enter < entry.enter; --at) entries_[at] = entries_[at - 1];
    entries_[at] = entry;
  }

 private:
  std::array<Entry, kDeepestBoxTree*(kBoxChildren - 1) + 1> entries_;
  std::size_t size_ = 0, first_ = 0;
};

/// Calls visit(item, enter), where no point of the ray in the item's box comes before t = enter ≥ 0, for the items
/// whose boxes the ray meets up to t = limit. `visit` returns the limit from then on; below 0 ends the walk.
template <class Visit>
HWY_INLINE void walk_boxes(const BoxTree& tree, const scene::Vec3& origin, const scene::Vec3& direction, double limit,
                           const Visit& visit) {
  struct Entry {
    double enter;
    std::uint32_t child;
  };
  bool is_parallel[3];
  unsigned near_side[3];
  double inverse[3];
  for (int axis = 0; axis < 3; ++axis) {
    inverse[axis] = 1 / direction[axis];
    is_parallel[axis] = !std::isfinite(inverse[axis]);
    near_side[axis] = direction[axis] < 0 ? 1 : 0;
  }
  BoxStack<Entry> stack;
  stack.push({0, 0});
  while (!stack.is_empty()) {
    const Entry top = stack.pop();
    if (top.enter > limit) continue;
    if ((top.child & BoxNode::kItem) != 0) {
      limit = visit(top.child & ~BoxNode::kItem, top.enter);
      if (limit < 0) return;
      continue;
    }
    const BoxNode& node = tree.nodes[top.child];
    Octet enter(0.0), leave(limit);
    OctetMask met = all_lanes();
    for (int axis = 0; axis < 3; ++axis) {
      const Octet o(origin[axis]);
      if (is_parallel[axis]) [[unlikely]] {
        met = met & (load(node.planes[axis][0]) <= o) & (o <= load(node.planes[axis][1]));
        continue;
      }
      const Octet by(inverse[axis]);
      enter = max(enter, (load(node.planes[axis][near_side[axis]]) - o) * by);
      leave = min(leave, (load(node.planes[axis][1 - near_side[axis]]) - o) * by);
    }
    enter = enter * Octet(kBoxEarlier);
    std::uint32_t left = bits(met & (enter <= leave * Octet(kBoxLater)));
    if (left == 0) continue;
    alignas(64) double begins[kOctet];
    store(enter, begins);
    stack.begin();
    for (; left != 0; left &= left - 1) {
      const int i = std::countr_zero(left);
      stack.push({begins[i], node.children[i]});
    }
  }
}

/// Eight rays side by side.
struct BoxRays {
  Octet origin[3], inverse[3];
  bool is_parallel = false;  ///< some ray does not move along some axis

  /// Rays without a bit in `open` may be anything.
  HWY_INLINE BoxRays(const Octet (&from)[3], const Octet (&along)[3], std::uint32_t open) {
    OctetMask is_finite = all_lanes();
    for (int axis = 0; axis < 3; ++axis) {
      origin[axis] = from[axis];
      inverse[axis] = Octet(1.0) / along[axis];
      is_finite = is_finite & (abs(inverse[axis]) < Octet(std::numeric_limits<double>::infinity()));
    }
    is_parallel = (open & ~bits(is_finite)) != 0;
  }

  /// The rays that are in a child's box somewhere between 0 and `limits`; none is before its `enter`.
  HWY_INLINE OctetMask meet(const BoxNode& node, std::size_t child, const Octet& limits, Octet& enter) const {
    enter = Octet(0.0);
    Octet leave = limits;
    for (int axis = 0; axis < 3; ++axis) {
      const Octet a = (Octet(node.planes[axis][0][child]) - origin[axis]) * inverse[axis];
      const Octet b = (Octet(node.planes[axis][1][child]) - origin[axis]) * inverse[axis];
      Octet from = min(a, b), to = max(a, b);
      if (is_parallel) [[unlikely]] {
        // 0·∞: the ray runs in a plane of the box.
        constexpr double kInfinite = std::numeric_limits<double>::infinity();
        const OctetMask is_sound = (a <= b) | (b <= a);
        from = select(is_sound, from, Octet(-kInfinite));
        to = select(is_sound, to, Octet(kInfinite));
      }
      enter = max(enter, from);
      leave = min(leave, to);
    }
    enter = enter * Octet(kBoxEarlier);
    return enter <= leave * Octet(kBoxLater);
  }
};

/// Bits of the children that are there.
[[nodiscard]] HWY_INLINE std::uint32_t children_of(const BoxNode& node) {
  return bits(load(node.planes[0][0]) <= load(node.planes[0][1]));
}

/// Bounds of the origins and directions of eight rays. A box that no line within them meets is met by none of the rays:
/// rounding keeps differences and products in their order, so that holds to the last bit.
class BoxBundle {
 public:
  HWY_INLINE BoxBundle() = default;
  HWY_INLINE BoxBundle(const BoxRays& rays, std::uint32_t open) {
    const Octet infinity(std::numeric_limits<double>::infinity());
    const OctetMask counts = mask_of(open);
    const auto lowest = [&](const Octet& x) HWY_ATTR { return least(select(counts, x, infinity)); };
    const auto highest = [&](const Octet& x) HWY_ATTR { return greatest(select(counts, x, Octet(0.0) - infinity)); };
    for (int axis = 0; axis < 3; ++axis) {
      const double low = lowest(rays.inverse[axis]), high = highest(rays.inverse[axis]);
      side_[axis] = low > 0 ? 0 : 1;
      is_bounded_[axis] = std::isfinite(low) && std::isfinite(high) && (low > 0) == (high > 0);
      by_[axis][0] = Octet(low);
      by_[axis][1] = Octet(high);
      from_[axis][0] = Octet(lowest(rays.origin[axis]));
      from_[axis][1] = Octet(highest(rays.origin[axis]));
    }
  }

  /// Bits of the children that some ray may meet before t = limit; no ray is in child i before begins[i], which are
  /// 64-byte aligned.
  [[nodiscard]] HWY_INLINE std::uint32_t meet(const BoxNode& node, double limit, double* begins) const {
    Octet enter(0.0), leave(limit);
    for (int axis = 0; axis < 3; ++axis) {
      if (!is_bounded_[axis]) [[unlikely]]
        continue;
      const unsigned near = side_[axis], far = 1 - near;
      const Octet to_near = load(node.planes[axis][near]) - from_[axis][far];
      const Octet to_far = load(node.planes[axis][far]) - from_[axis][near];
      enter = max(enter, min(to_near * by_[axis][0], to_near * by_[axis][1]));
      leave = min(leave, max(to_far * by_[axis][0], to_far * by_[axis][1]));
    }
    enter = enter * Octet(kBoxEarlier);
    store(enter, begins);
    return children_of(node) & bits(enter <= leave * Octet(kBoxLater));
  }

 private:
  Octet from_[3][2], by_[3][2];  ///< least and greatest origins and inverses of directions
  unsigned side_[3] = {};        ///< which of a box's planes is met first
  bool is_bounded_[3] = {};      ///< the rays move to the same side along the axis
};

/// The same for the rays whose bits in `open` are set, with the limits of all rays in `limits` (64-byte aligned), which
/// `visit` may lower. visit(item, rays) returns the bits of the rays that go on. Returns those that go on in the end.
template <class Visit>
HWY_INLINE std::uint32_t walk_boxes(const BoxTree& tree, const BoxRays& rays, const double* limits, std::uint32_t open,
                                    const Visit& visit) {
  struct Entry {
    double enter;  ///< none of the rays is in the box before
    std::uint32_t child, rays;
  };
  // A bundle costs more than it saves where there are few boxes.
  const bool is_bundled = tree.nodes.size() > kBoxChildren;
  BoxBundle bundle;
  if (is_bundled) bundle = BoxBundle(rays, open);
  double farthest = greatest(keep(mask_of(open), load(limits)));
  BoxStack<Entry> stack;
  stack.push({0, 0, open});
  while (!stack.is_empty()) {
    const Entry top = stack.pop();
    const std::uint32_t present = top.rays & open;
    if (present == 0 || top.enter > farthest) continue;
    if ((top.child & BoxNode::kItem) != 0) {
      open &= ~present | visit(top.child & ~BoxNode::kItem, present);
      if (open == 0) return open;
      farthest = greatest(keep(mask_of(open), load(limits)));
      continue;
    }
    const BoxNode& node = tree.nodes[top.child];
    const Octet up_to = load(limits);
    alignas(64) double begins[kOctet];
    std::uint32_t left = is_bundled ? bundle.meet(node, farthest, begins) : children_of(node);
    stack.begin();
    for (; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      Octet enter;
      const OctetMask meeting = rays.meet(node, i, up_to, enter) & mask_of(present);
      const std::uint32_t met = bits(meeting);
      if (met == 0) continue;
      const double begin = is_bundled ? begins[i] : least(select(meeting, enter, up_to));
      stack.push({begin, node.children[i], met});
    }
  }
  return open;
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
