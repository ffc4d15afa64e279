// Compiles the database's groups to CSG trees.
#pragma once

#include "base/run_limits.h"
#include "renderer/csg/csg_tree.h"
#include "renderer/csg/expansion.h"
#include "renderer/extents/extents.h"

#include <map>
#include <tuple>
#include <vector>

namespace isl::render {

/// Makes the CSG trees of a scene, each distinct tree once.
class CsgBuilder {
 public:
  /// `meter` refuses trees that would take too much memory; they are then incomplete. `charge` counts their bytes.
  CsgBuilder(const scene::Database& database, const Expansion& expansion, Meter& meter, Charge& charge);
  ~CsgBuilder();

  /// Index of the object's tree in what take_trees() will return. The tree does not depend on the object's own
  /// transform and texture.
  [[nodiscard]] std::uint32_t tree_of(const scene::Object& object, bool is_inverse);

  [[nodiscard]] std::vector<CsgTree> take_trees() { return std::move(trees_); }

 private:
  struct Above;
  struct Level;
  void add(CsgTree& tree, const scene::Object& object, const Above& above);
  void add_shape(CsgTree& tree, const scene::Object& object, const Above& above);
  void open_group(CsgTree& tree, Level& level);
  void add_leaf(CsgTree& tree, const scene::Object& object, const Above& above);
  [[nodiscard]] Imath::Box3d box_of_leaf(const CsgLeaf& leaf);
  [[nodiscard]] bool cuts_all(const CsgTree& tree, const CsgLeaf& leaf) const;
  /// CsgTree::is_met_by_octets.
  [[nodiscard]] bool fits_octets(const CsgTree& tree) const;
  void add_boxes(CsgTree& tree);

  const scene::Database& database_;
  const Expansion& expansion_;
  Meter& meter_;
  Charge& charge_;
  Extents extents_;
  /// The key is the kind, the shape, the clip, the object's own inverse, and its parent's.
  std::map<std::tuple<scene::Object::Kind, std::uint32_t, scene::GroupId, bool, bool>, std::uint32_t> known_;
  std::vector<CsgTree> trees_;
  /// The groups that are being added, the innermost last: a list instead of recursion, so that depth costs no stack.
  std::vector<Level> open_;
};

}  // namespace isl::render
