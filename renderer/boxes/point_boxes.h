// Trees of boxes (box_tree.h) for points instead of rays: which boxes hold a point?
//
// A tree for rays is divided where few rays meet both parts, and half of its nodes' places are empty. A point is in few
// boxes anyway; for it, items are halved by number, and all nodes but the last ones are full. Such a tree takes a third
// of the memory and is built in a third of the time.
#pragma once

#include "renderer/boxes/box_tree.h"
#include "renderer/scene/transform.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace isl::render {

/// As build_box_tree().
[[nodiscard]] BoxTree build_point_tree(std::span<const Imath::Box3d> boxes, std::vector<std::uint32_t> items,
                                       const std::function<bool()>& may_add);

/// Calls visit(item) for the items whose boxes hold the point.
template <class Visit>
void visit_boxes_around(const BoxTree& tree, const scene::Vec3& point, const Visit& visit) {
  if (tree.is_empty()) return;
  std::array<std::uint32_t, kDeepestBoxTree*(kBoxChildren - 1) + 1> open;
  std::size_t count = 0;
  open[count++] = 0;
  while (count > 0) {
    const BoxNode& node = tree.nodes[open[--count]];
    std::uint32_t holding = 0;
    for (std::size_t i = 0; i < kBoxChildren; ++i) {
      bool holds = true;
      for (int axis = 0; axis < 3; ++axis)
        holds = holds & (node.planes[axis][0][i] <= point[axis]) & (point[axis] <= node.planes[axis][1][i]);
      holding |= std::uint32_t{holds} << i;
    }
    for (; holding != 0; holding &= holding - 1) {
      const std::uint32_t child = node.children[std::countr_zero(holding)];
      if ((child & BoxNode::kItem) != 0) {
        visit(child & ~BoxNode::kItem);
        continue;
      }
      // Most of the time is spent waiting for memory: a node is fetched while those before it are looked at.
      for (const auto& axis : tree.nodes[child].planes) {
        for (const auto& side : axis) __builtin_prefetch(side);
      }
      open[count++] = child;
    }
  }
}

}  // namespace isl::render
