// The value of a CSG expression while its leaves change one by one: each node counts its children that hold, so a
// change costs the depth of the tree and not its size.
#pragma once

#include "renderer/csg/csg_tree.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace isl::render {

class CsgState {
 public:
  /// Puts all leaves outside. The tree must outlive this state.
  void reset(const CsgTree& tree) {
    tree_ = &tree;
    holding_.assign(tree.holding_at_rest.begin(), tree.holding_at_rest.end());
    is_inside_.assign(tree.leaves.size(), 0);
  }

  [[nodiscard]] bool is_inside(std::uint32_t leaf) const { return is_inside_[leaf] != 0; }
  [[nodiscard]] bool leaf_holds(std::uint32_t leaf) const {
    const CsgLeaf& own = tree_->leaves[leaf];
    return !own.is_open_surface && is_inside(leaf) != own.is_inverse;
  }
  [[nodiscard]] bool node_holds(std::uint32_t node) const { return tree_->nodes[node].holds(holding_[node]); }
  [[nodiscard]] bool holds() const { return node_holds(0); }

  /// Moves the leaf between its inside and its outside.
  void toggle(std::uint32_t leaf) {
    is_inside_[leaf] ^= 1;
    const CsgLeaf& own = tree_->leaves[leaf];
    if (own.is_open_surface) return;
    bool holds_now = leaf_holds(leaf);
    for (std::uint32_t node = own.parent; node != scene::kNone; node = tree_->nodes[node].parent) {
      const bool held = node_holds(node);
      holding_[node] += holds_now ? 1u : ~0u;
      holds_now = node_holds(node);
      if (holds_now == held) return;
    }
  }

  /// True if a surface of the leaf is a surface of the whole here, whatever the leaf's own state: the place is inside
  /// everything that the leaf is intersected with, and outside everything that it is merged with.
  [[nodiscard]] bool shows(std::uint32_t leaf) const {
    bool own = leaf_holds(leaf);
    for (std::uint32_t node = tree_->leaves[leaf].parent; node != scene::kNone; node = tree_->nodes[node].parent) {
      const CsgNode& n = tree_->nodes[node];
      const std::uint32_t others = holding_[node] - (own ? 1 : 0);
      if (n.kind == CsgNode::Kind::all && others + 1 != n.child_count) return false;
      if (n.kind == CsgNode::Kind::merge && others != 0) return false;
      own = n.holds(holding_[node]);
    }
    return true;
  }

  /// Keeps the present values for changed_with().
  void remember() { before_.assign(holding_.begin(), holding_.end()); }

  /// Precondition: the leaf began or ceased to hold since remember(). True if every node from it to the root did so
  /// alike; the leaf's surface is then where the whole changed.
  [[nodiscard]] bool changed_with(std::uint32_t leaf) const {
    const bool now = leaf_holds(leaf);
    for (std::uint32_t node = tree_->leaves[leaf].parent; node != scene::kNone; node = tree_->nodes[node].parent) {
      if (node_holds(node) != now || tree_->nodes[node].holds(before_[node]) == now) return false;
    }
    return true;
  }

 private:
  const CsgTree* tree_ = nullptr;
  std::vector<std::uint32_t> holding_, before_;
  std::vector<std::uint8_t> is_inside_;
};

}  // namespace isl::render
