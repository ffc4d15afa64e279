// A combination of solids and blobs by `intersection`, `difference`, `merge` and `clipped_by`, flat and ready for rays:
// an expression over leaves, each of which is inside or outside at any point of a ray. It is compiled once for each
// distinct group (csg_builder.h), shared by its copies, and followed along rays by csg_search.h.
//
// Only leaves are negated: `difference` is an intersection with inverse objects, and an inverse intersection is a merge
// of inverses.
#pragma once

#include "renderer/boxes/box_tree.h"
#include "renderer/csg/spread.h"
#include "renderer/extents/bounding_planes.h"
#include "renderer/scene/database.h"

#include <ImathBox.h>

#include <cstdint>
#include <vector>

namespace isl::render {

/// The space in which the texture of an instance or leaf lives. kOwnSpace is that of the shape itself, kOuterSpace is
/// the one around it (the world, or the tree's group), and any other value is the index of the space of a group in
/// between, which handed the texture down.
using TextureSpace = std::uint32_t;
inline constexpr TextureSpace kOwnSpace = 0xFFFFFFFF, kOuterSpace = 0xFFFFFFFE;

/// A texture that an object has or inherits.
struct PlacedTexture {
  scene::TextureId id = scene::kNoTexture;
  TextureSpace space = kOuterSpace;
};

struct CsgNode {
  /// `unite` differs from `merge` in that it keeps the surfaces inside.
  enum class Kind : std::uint8_t { all, unite, merge };
  Kind kind = Kind::all;
  std::uint32_t parent = scene::kNone;
  std::uint32_t child_count = 0;

  [[nodiscard]] bool holds(std::uint32_t holding_children) const {
    return kind == Kind::all ? holding_children == child_count : holding_children > 0;
  }
};

struct CsgLeaf {
  scene::Object::Kind kind = scene::Object::Kind::solid;  ///< solid or blob
  bool is_seen = true;                                    ///< false for a leaf that clips: its surface is not drawn
  bool is_inverse = false;                                ///< holds outside rather than inside; its normals are flipped
  bool is_open_surface = false;  ///< has no inside: holds nowhere, inverse or not, as in POV-Ray
  bool is_placed = false;        ///< false: its space is the group's
  std::uint32_t shape = 0;
  std::uint32_t parent = 0;  ///< index of its node
  /// Its own texture, or that of the nearest group in the tree that has one; else kNoTexture.
  PlacedTexture texture;
  PlacedTexture interior_texture;                   ///< likewise: of the surface seen from inside
  scene::InteriorId interior = scene::kNoInterior;  ///< its own, or that of the nearest group in the tree that has one
  std::uint32_t holder = 0;  ///< number of the leaf or group that has the interior, from 1; 0 if there is none
  /// The nearest group above with `cutaway_textures`, if the leaf has no texture from within that group; else kNone.
  std::uint32_t cutaway = scene::kNone;
  scene::Transform group_from_leaf;
  /// In the group's space: beyond it the leaf is outside, or changes nothing, because something that it is intersected
  /// with is outside. Sides may be infinite.
  Imath::Box3d box;
  double size = 0;  ///< the largest coordinate in its own space that its surface is computed from
};

/// Combinations with more leaves or nodes are not met by eight rays at once. The work for all crossings grows with the
/// square of the leaves, and csg_search.h asks only those near the ray's first surface.
inline constexpr std::size_t kMostOctetLeaves = 10, kMostOctetNodes = 10;

/// A leaf that is a plane and cuts the whole: where the leaf does not hold, nothing of the tree is seen.
struct CuttingPlane {
  BoundingPlane plane;  ///< in the group's space; holds where n·x ≤ d
  std::uint32_t leaf;
};

struct CsgTree {
  std::vector<CsgNode> nodes;  ///< parents before children; the first is the root
  std::vector<CsgLeaf> leaves;
  std::vector<scene::Transform> texture_spaces;  ///< group_from_space of each group that hands a pattern down
  /// For every node, the number of its children that hold where no leaf is inside.
  std::vector<std::uint32_t> holding_at_rest;
  BoxTree boxes;                              ///< over the leaves with finite boxes
  std::vector<CuttingPlane> cutting_planes;   ///< leaves whose groups are all of the kind `all`
  std::vector<std::uint32_t> endless_leaves;  ///< all others
  Imath::Box3d bounds;                        ///< bounds of the surface; sides may be infinite
  Spread spread;                              ///< covers every leaf
  std::uint32_t holders = 0;                  ///< leaves and groups with an interior of their own
  /// True if there are few leaves, all of them solids whose stretches inside are found for eight rays at once.
  bool is_met_by_octets = false;

  [[nodiscard]] std::size_t bytes() const {
    return nodes.capacity() * sizeof(CsgNode) + leaves.capacity() * sizeof(CsgLeaf) +
           (holding_at_rest.capacity() + endless_leaves.capacity()) * sizeof(std::uint32_t) + boxes.bytes() +
           cutting_planes.capacity() * sizeof(CuttingPlane);
  }
};

}  // namespace isl::render
