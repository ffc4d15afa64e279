#include "renderer/csg/csg_builder.h"

#include "renderer/csg/shape_size.h"
#include "renderer/csg/spread.h"
#include "renderer/extents/box_operations.h"
#include "renderer/solids/octet_solids.h"
#include "renderer/solids/solid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isl::render {

using scene::Group;
using scene::Object;
using scene::Operation;

namespace {

CsgNode::Kind kind_of(Operation operation, bool is_inverse) {
  switch (operation) {
    case Operation::unite: return is_inverse ? CsgNode::Kind::all : CsgNode::Kind::unite;
    case Operation::merge: return is_inverse ? CsgNode::Kind::all : CsgNode::Kind::merge;
    case Operation::intersect:
    case Operation::subtract: break;
  }
  return is_inverse ? CsgNode::Kind::merge : CsgNode::Kind::all;
}

std::size_t bytes_of(const Expansion::Size& size) {
  const double bytes = (size.groups + 1) * (sizeof(CsgNode) + sizeof(std::uint32_t)) + size.leaves * sizeof(CsgLeaf);
  constexpr double kMost = 0x1p62;
  return static_cast<std::size_t>(std::min(bytes, kMost));
}

/// Widens a box by more than rounding moves a ray, so that a leaf is wrongly excluded at most for rays that touch it
/// only by a rounding.
Box widened(Box box) {
  if (box.isEmpty()) return box;
  for (int i = 0; i < 3; ++i) {
    const double low = std::abs(box.min[i]), high = std::abs(box.max[i]);
    const double margin = 0x1p-40 * ((std::isfinite(low) ? low : 0) + (std::isfinite(high) ? high : 0));
    box.min[i] -= margin;
    box.max[i] += margin;
  }
  return box;
}

constexpr double kFar = std::numeric_limits<double>::infinity();
const Box kEverywhere{Vec3(-kFar), Vec3(kFar)};

}  // namespace

/// State that an object inherits from its parent.
struct CsgBuilder::Above {
  std::uint32_t parent = scene::kNone;
  scene::Transform group_from_parent{};
  PlacedTexture texture{}, interior_texture{};
  scene::InteriorId interior = scene::kNoInterior;
  std::uint32_t holder = 0;
  std::uint32_t cutaway = scene::kNone;
  bool is_inverse = false;
  bool is_seen = true;
  Box within = kEverywhere;  ///< beyond it the state of what is added changes nothing, in the tree's space
};

/// A group with what it inherits. As soon as it is open it hands `above` on to its children, and has a node if it needs
/// one.
struct CsgBuilder::Level {
  const Group* group;
  Above above;
  bool is_open = false;
  bool is_inverse = false;  ///< the group's parent, or its object, is inverse
  std::size_t next = 0;     ///< child
};

CsgBuilder::CsgBuilder(const scene::Database& database, const Expansion& expansion, Meter& meter, Charge& charge)
    : database_(database), expansion_(expansion), meter_(meter), charge_(charge), extents_(database) {}
CsgBuilder::~CsgBuilder() = default;

std::uint32_t CsgBuilder::tree_of(const Object& object, bool is_inverse) {
  const auto [place, is_new] = known_.try_emplace({object.kind, object.shape, object.clip, object.inverse, is_inverse},
                                                  static_cast<std::uint32_t>(trees_.size()));
  if (!is_new) return place->second;
  Object alone;
  alone.kind = object.kind;
  alone.shape = object.shape;
  alone.clip = object.clip;
  alone.inverse = object.inverse;
  CsgTree tree;
  const Expansion::Size size = expansion_.tree_of(alone);
  if (!meter_.grow(charge_, bytes_of(size))) return place->second;
  tree.nodes.reserve(static_cast<std::size_t>(size.groups) + 1);
  tree.leaves.reserve(static_cast<std::size_t>(size.leaves));
  tree.nodes.push_back({});
  add(tree, alone, {.parent = 0, .is_inverse = is_inverse});
  while (!open_.empty()) {
    Level& level = open_.back();
    if (!level.is_open) open_group(tree, level);
    if (level.next == level.group->children.size()) {
      open_.pop_back();
      continue;
    }
    const bool is_taken_away = level.group->operation == Operation::subtract && level.next > 0;
    Above own = level.above;  // a copy, because adding the child moves the list
    own.is_inverse = level.is_inverse != is_taken_away;
    add(tree, level.group->children[level.next++], own);
    if (!meter_.goes_on()) open_.clear();
  }
  tree.bounds = widened(extents_.of(alone));
  add_boxes(tree);
  tree.holding_at_rest.assign(tree.nodes.size(), 0);
  for (const CsgLeaf& leaf : tree.leaves) {
    if (leaf.is_inverse && !leaf.is_open_surface) ++tree.holding_at_rest[leaf.parent];
  }
  for (std::size_t i = tree.nodes.size() - 1; i > 0; --i) {  // children before parents
    if (tree.nodes[i].holds(tree.holding_at_rest[i])) ++tree.holding_at_rest[tree.nodes[i].parent];
  }
  tree.is_met_by_octets = fits_octets(tree);
  trees_.push_back(std::move(tree));
  return place->second;
}

bool CsgBuilder::fits_octets(const CsgTree& tree) const {
  return tree.leaves.size() <= kMostOctetLeaves && tree.nodes.size() <= kMostOctetNodes &&
         std::ranges::all_of(tree.leaves, [this](const CsgLeaf& leaf) {
           return leaf.kind == Object::Kind::solid && has_octet_stretches(database_.solids[leaf.shape]);
         });
}

bool CsgBuilder::cuts_all(const CsgTree& tree, const CsgLeaf& leaf) const {
  if (leaf.kind != Object::Kind::solid || database_.solids[leaf.shape].kind != scene::SolidKind::plane) return false;
  for (std::uint32_t node = leaf.parent; node != scene::kNone; node = tree.nodes[node].parent) {
    if (tree.nodes[node].kind != CsgNode::Kind::all) return false;
  }
  return true;
}

void CsgBuilder::add_boxes(CsgTree& tree) {
  std::vector<Box> boxes;
  std::vector<std::uint32_t> finite;
  Charge working = meter_.new_charge();
  if (!meter_.grow(working, tree.leaves.size() * (sizeof(Box) + 2 * sizeof(CuttingPlane)))) return;
  boxes.reserve(tree.leaves.size());
  for (std::uint32_t i = 0; i < tree.leaves.size(); ++i) {
    const Box& box = boxes.emplace_back(tree.leaves[i].box);
    if (box.isEmpty()) continue;  // the leaf is outside everywhere
    if (cuts_all(tree, tree.leaves[i])) {
      const CsgLeaf& leaf = tree.leaves[i];
      tree.cutting_planes.push_back(
          {bounding_plane(database_.solids[leaf.shape], leaf.group_from_leaf, leaf.is_inverse), i});
      continue;
    }
    (fits_in_tree(box) ? finite : tree.endless_leaves).push_back(i);
  }
  tree.boxes = build_box_tree(boxes, std::move(finite), [&] { return meter_.grow(charge_, sizeof(BoxNode)); });
}

void CsgBuilder::add(CsgTree& tree, const Object& object, const Above& above) {
  if (!meter_.goes_on()) return;
  Above own = above;
  own.group_from_parent = then(object.parent_from_object, above.group_from_parent);
  if (object.interior != scene::kNoInterior) {
    own.interior = object.interior;
    own.holder = ++tree.holders;
  }
  const auto take = [&](scene::TextureId id, PlacedTexture& texture) {
    if (id == scene::kNoTexture) return true;
    texture = {id, kOwnSpace};
    if (object.kind != Object::Kind::group || database_.texture(id).is_plain()) return true;
    texture.space = static_cast<TextureSpace>(tree.texture_spaces.size());
    if (!meter_.grow(charge_, 2 * sizeof(scene::Transform))) return false;
    tree.texture_spaces.push_back(own.group_from_parent);
    return true;
  };
  if (!take(object.texture, own.texture) || !take(object.interior_texture, own.interior_texture)) return;
  if (object.clip == scene::kNoGroup) {
    own.is_inverse ^= object.inverse;
    add_shape(tree, object, own);
    return;
  }
  // A clipped shape is the intersection of the shape and its clip, whose own surface is not seen. Inverting the shape
  // does not invert the clip.
  ++tree.nodes[above.parent].child_count;
  own.parent = static_cast<std::uint32_t>(tree.nodes.size());
  tree.nodes.push_back({above.is_inverse ? CsgNode::Kind::merge : CsgNode::Kind::all, above.parent, 0});
  Above of_clip = own;
  of_clip.is_seen = false;
  own.within = common_box(own.within, widened(box_through(own.group_from_parent, extents_.inside_of(object.clip))));
  own.is_inverse ^= object.inverse;
  open_.push_back({&database_.groups[index(object.clip)], of_clip});  // below the shape in the list, so after it
  add_shape(tree, object, own);
}

void CsgBuilder::add_shape(CsgTree& tree, const Object& object, const Above& above) {
  if (object.kind == Object::Kind::group) {
    open_.push_back({&database_.groups[object.shape], above});
  } else {
    add_leaf(tree, object, above);
  }
}

void CsgBuilder::open_group(CsgTree& tree, Level& level) {
  const Group& group = *level.group;
  level.is_inverse = level.above.is_inverse;
  level.is_open = true;
  // An empty group is the empty set, whatever its operation: a union without children holds nowhere. Groups of empty
  // groups are as many as others.
  const bool is_nothing = expansion_.is_nothing(static_cast<std::uint32_t>(&group - database_.groups.data()));
  if (is_nothing) level.next = group.children.size();
  const Operation operation = is_nothing ? Operation::unite : group.operation;
  const CsgNode::Kind kind = kind_of(operation, level.is_inverse);
  // A difference whose first object is a difference is one difference, and so on. So a chain of them, however long, is
  // one node, and an event does not climb it.
  if (operation == Operation::intersect || operation == Operation::subtract) {
    const auto id = scene::GroupId{static_cast<std::uint32_t>(&group - database_.groups.data())};
    level.above.within =
        common_box(level.above.within, widened(box_through(level.above.group_from_parent, extents_.inside_of(id))));
  }
  if (kind == tree.nodes[level.above.parent].kind && !group.cutaway_textures) return;
  ++tree.nodes[level.above.parent].child_count;
  const auto node = static_cast<std::uint32_t>(tree.nodes.size());
  tree.nodes.push_back({kind, level.above.parent, 0});
  level.above.parent = node;
  if (group.cutaway_textures) level.above.cutaway = node;
}

void CsgBuilder::add_leaf(CsgTree& tree, const Object& object, const Above& above) {
  ++tree.nodes[above.parent].child_count;
  CsgLeaf leaf;
  leaf.kind = object.kind;
  leaf.is_seen = above.is_seen;
  leaf.is_inverse = above.is_inverse;
  leaf.is_open_surface = object.kind == Object::Kind::solid && is_open_surface(database_.solids[object.shape]);
  leaf.is_placed = above.group_from_parent.matrix != scene::Matrix();
  leaf.shape = object.shape;
  leaf.parent = above.parent;
  leaf.texture = above.texture;
  leaf.interior_texture = above.interior_texture;
  leaf.interior = above.interior;
  leaf.holder = above.holder;
  if (leaf.texture.id == scene::kNoTexture) leaf.cutaway = above.cutaway;
  leaf.group_from_leaf = above.group_from_parent;
  leaf.box = widened(box_of_leaf(leaf));
  leaf.box = common_box(leaf.box, above.within);
  leaf.size = shape_size(database_, leaf.kind, leaf.shape);
  Spread spread = spread_of_shape(leaf.size);
  if (leaf.is_placed) spread = spread_through(leaf.group_from_leaf, spread);
  tree.spread = {std::max(tree.spread.factor, spread.factor), std::max(tree.spread.size, spread.size)};
  tree.leaves.push_back(leaf);
}

Box CsgBuilder::box_of_leaf(const CsgLeaf& leaf) {
  // Such a solid's inside is a half-space.
  if (leaf.kind == Object::Kind::solid && is_part_of_plane(database_.solids[leaf.shape])) return kEverywhere;
  Object placed;
  placed.kind = leaf.kind;
  placed.shape = leaf.shape;
  placed.parent_from_object = leaf.group_from_leaf;
  return extents_.of(placed);
}

}  // namespace isl::render
