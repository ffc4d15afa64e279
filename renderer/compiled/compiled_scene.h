// A database made ready for rays: every blob compiled once in its own space, everything placed flattened into instances, and a
// top-level grid over them. Immutable; one struct on one screen.
#pragma once

#include "renderer/compiled/paper_tables.h"
#include "renderer/csg/csg_tree.h"
#include "renderer/fields/component_table.h"
#include "renderer/grid/blob_grid.h"
#include "renderer/grid/grid.h"
#include "renderer/scene/coordinate_textures.h"
#include "renderer/scene/database.h"
#include "renderer/solids/solid_details.h"

#include <limits>
#include <vector>

namespace isl::render {

struct CompiledBlob {
  ComponentTable components;
  Grid grid;
  PaperTables paper;  ///< empty but for the published solver
  double size = 0;    ///< the largest coordinate that its surface is computed from

  /// Of all that it has, in its own space; infinite where it has half-spaces, empty where it has no surface.
  [[nodiscard]] Box bounds() const {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    return grid.beyond == scene::kNone ? grid.bounds : Box(Vec3(-kFar), Vec3(kFar));
  }
};

/// A solid, a blob or a combination of such that stands somewhere. Its number is its InstanceId.
struct Instance {
  scene::Object::Kind kind;  ///< `group`: `shape` is the number of a CSG tree
  std::uint8_t hidden_from;  ///< kinds of rays that pass it by: the bits of RayKind
  bool is_placed;   ///< false: object space is world space
  bool is_inverse;  ///< its normals point inwards; a CSG tree knows that itself
  std::uint32_t shape;
  scene::TextureId texture;
  TextureSpace texture_space;
  scene::Transform world_from_object;
  OriginId origin;
  double size = 0;  ///< of a solid or blob: the largest coordinate in its own space that its surface is computed from
  Spread spread;    ///< in the world
};

struct CompiledScene {
  std::vector<scene::Solid> solids;
  SolidDetails details;  ///< of those
  std::vector<CompiledBlob> blobs;
  scene::CoordinateTextures coordinate_textures;
  std::vector<CsgTree> trees;
  std::vector<scene::Transform> texture_spaces;  ///< world_from_space, of groups that hand a pattern down
  std::vector<Instance> instances;
  std::vector<std::uint32_t> unbounded;  ///< instances without a finite box: half-spaces
  std::vector<std::uint32_t> bounded;    ///< all other instances
  Grid grid;                             ///< over the bounded ones
  Box bounds;                            ///< of those

  [[nodiscard]] std::size_t grid_bytes() const;
};

struct CompileOptions {
  CellRule cells = CellRule::ranges;
  bool skeleton = false;  ///< every blob as its skeleton model
};

[[nodiscard]] CompiledScene compile(const scene::Database& database, const CompileOptions& options);

}  // namespace isl::render
