// A hierarchy of boxes with eight children a node, so that a vector unit tests all children of a node at once. Each
// item is in one place only, so a ray asks about it once, and boxes of very different sizes do not disturb one another.
#pragma once

#include "renderer/scene/ids.h"

#include <ImathBox.h>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace isl::render {

inline constexpr std::size_t kBoxChildren = 8;
/// Nodes on the longest way down; from a certain depth on, items are halved by their number.
inline constexpr std::size_t kDeepestBoxTree = 64;

struct alignas(64) BoxNode {
  double planes[3][2][kBoxChildren];  ///< by axis, the least and the greatest coordinates of the children; a child
                                      ///< that is not there begins at +∞ and ends at −∞, so that no ray meets it
  std::uint32_t children[kBoxChildren];  ///< an item's number with kItem, or a node's
  static constexpr std::uint32_t kItem = 0x80000000;
};

/// Immutable once it is built.
struct BoxTree {
  std::vector<BoxNode> nodes;  ///< parents before children; the first is the root

  [[nodiscard]] bool is_empty() const { return nodes.empty(); }
  [[nodiscard]] std::size_t bytes() const { return nodes.capacity() * sizeof(BoxNode); }
};

/// True if a box has room and an end: products of three such lengths, summed over all items, are numbers.
[[nodiscard]] bool fits_in_tree(const Imath::Box3d& box);

/// Builds the tree over `items`, which are indices into `boxes`; their boxes fit. Their number is
/// below 2³¹. `may_add` is asked before each node; once it returns false, the tree is of no use.
[[nodiscard]] BoxTree build_box_tree(std::span<const Imath::Box3d> boxes, std::vector<std::uint32_t> items,
                                     const std::function<bool()>& may_add);

}  // namespace isl::render
