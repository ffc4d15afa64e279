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

  /// Where the rays are in a child's box, between 0 and `limits`.
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

/// The same for the rays whose bits in `open` are set, with the limits of all rays in `limits` (64-byte aligned), which
/// `visit` may lower. visit(item, rays) returns the bits of the rays that go on. Returns those that go on in the end.
template <class Visit>
HWY_INLINE std::uint32_t walk_boxes(const BoxTree& tree, const BoxRays& rays, const double* limits, std::uint32_t open,
                                    const Visit& visit) {
  struct Entry {
    double enter;  ///< of one of the rays
    std::uint32_t child, rays;
  };
  BoxStack<Entry> stack;
  stack.push({0, 0, open});
  while (!stack.is_empty()) {
    const Entry top = stack.pop();
    const std::uint32_t present = top.rays & open;
    if (present == 0) continue;
    if ((top.child & BoxNode::kItem) != 0) {
      open &= ~present | visit(top.child & ~BoxNode::kItem, present);
      if (open == 0) return open;
      continue;
    }
    const BoxNode& node = tree.nodes[top.child];
    const Octet up_to = load(limits);
    stack.begin();
    for (std::size_t i = 0; i < kBoxChildren; ++i) {
      if (!(node.planes[0][0][i] <= node.planes[0][1][i])) break;  // children that are there come first
      Octet enter;
      const std::uint32_t met = bits(rays.meet(node, i, up_to, enter)) & present;
      if (met == 0) continue;
      alignas(64) double begins[kOctet];
      store(enter, begins);
      stack.push({begins[std::countr_zero(met)], node.children[i], met});
    }
  }
  return open;
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
