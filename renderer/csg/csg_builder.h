// From the database's groups to CSG trees.
#pragma once

#include "renderer/csg/csg_tree.h"
#include "renderer/extents/extents.h"

#include <map>
#include <tuple>
#include <vector>

namespace isl::render {

/// Whether an object is more than its parts side by side: combined by an operation, clipped, or a union turned inside
/// out. `is_inverse`: what holds it is.
[[nodiscard]] bool needs_csg(const scene::Database& database, const scene::Object& object, bool is_inverse);

/// Makes each distinct tree once.
class CsgBuilder {
 public:
  explicit CsgBuilder(const scene::Database& database) : database_(database), extents_(database) {}

  /// The number of the object's tree among those taken in the end. The object's own place and texture are no part of
  /// it.
  [[nodiscard]] std::uint32_t tree_of(const scene::Object& object, bool is_inverse);

  [[nodiscard]] std::vector<CsgTree> take_trees() { return std::move(trees_); }

 private:
  struct Above;
  void add(CsgTree& tree, const scene::Object& object, const Above& above);
  void add_shape(CsgTree& tree, const scene::Object& object, const Above& above);
  void add_group(CsgTree& tree, const scene::Group& group, const Above& above);
  void add_leaf(CsgTree& tree, const scene::Object& object, const Above& above);
  [[nodiscard]] Imath::Box3d box_of_leaf(const CsgLeaf& leaf);

  const scene::Database& database_;
  Extents extents_;
  /// By kind, shape, clip, the object's own inverse, and that of what holds it.
  std::map<std::tuple<scene::Object::Kind, std::uint32_t, scene::GroupId, bool, bool>, std::uint32_t> known_;
  std::vector<CsgTree> trees_;
};

}  // namespace isl::render
