#include "renderer/trace/cutaway.h"

#include "renderer/solids/solid.h"

namespace isl::render {
namespace {

bool is_below(const CsgTree& tree, const CsgLeaf& leaf, std::uint32_t node) {
  for (std::uint32_t above = leaf.parent; above != scene::kNone; above = tree.nodes[above].parent) {
    if (above == node) return true;
  }
  return false;
}

/// Counts the crossings of a line from the point. Any direction serves.
bool holds(const CompiledScene& scene, const CsgLeaf& leaf, const Vec3& point) {
  if (leaf.kind != scene::Object::Kind::solid || leaf.is_open_surface) return false;
  const Vec3 origin = leaf.is_placed ? leaf.group_from_leaf.inverse_point(point) : point;
  const Crossings found = boundary(scene.solids[leaf.shape], origin, Vec3(0.48, 0.6, 0.64), kNoPart, scene.details);
  bool is_inside = found.ends_inside;
  for (std::size_t i = 0; i < static_cast<std::size_t>(found.count); ++i) is_inside ^= found.t[i] > 0;
  return is_inside;
}

}  // namespace

const CsgLeaf* leaf_cut_away(const CompiledScene& scene, const CsgTree& tree, const CsgLeaf& leaf, const Vec3& point) {
  const CsgLeaf* first = nullptr;
  if (leaf.cutaway == scene::kNone) return first;
  for (const CsgLeaf& other : tree.leaves) {
    if (other.texture.id == scene::kNoTexture || other.is_inverse || !is_below(tree, other, leaf.cutaway)) continue;
    if (!first) first = &other;
    if (holds(scene, other, point)) return &other;
  }
  return first;
}

}  // namespace isl::render
