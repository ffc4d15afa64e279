// A database made ready for rays: every blob is compiled once in its own space, every placed object is flattened into
// an instance, and a hierarchy of boxes stands over the instances. Immutable; one struct on one screen.
#pragma once

#include "base/run_limits.h"
#include "renderer/boxes/box_tree.h"
#include "renderer/compiled/paper_tables.h"
#include "renderer/csg/csg_tree.h"
#include "renderer/fields/component_table.h"
#include "renderer/grid/blob_grid.h"
#include "renderer/grid/grid.h"
#include "renderer/rays/light_group.h"
#include "renderer/scene/coordinate_textures.h"
#include "renderer/scene/database.h"
#include "renderer/scene/refusal.h"
#include "renderer/solids/solid_details.h"

#include <limits>
#include <optional>
#include <vector>

namespace isl::render {

struct CompiledBlob {
  ComponentTable components;
  Grid grid;
  PaperTables paper;  ///< filled only for the published solver
  double size = 0;    ///< the largest coordinate that its surface is computed from

  /// True if the field is one sum everywhere, not the greatest of several, and all components have one texture.
  [[nodiscard]] bool is_one_sum() const {
    return components.has_one_texture && components.branch.empty() && !components.is_unblended;
  }
  /// Bounds of the content in the blob's own space; infinite if the blob has half-spaces, empty if it has no surface.
  [[nodiscard]] Box bounds() const {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    return grid.beyond == scene::kNone ? grid.bounds : Box(Vec3(-kFar), Vec3(kFar));
  }
};

/// A placed solid, blob or CSG tree. Its index is its InstanceId.
struct Instance {
  scene::Object::Kind kind;     ///< for `group`, `shape` is the index of a CSG tree
  std::uint8_t hidden_from;     ///< the kinds of rays that do not meet it, as bits of RayKind, kOnlyOpaque, kOnlyClear
  bool is_placed;               ///< false: object space is world space
  bool is_inverse;              ///< normals point inwards; false for a CSG tree, whose leaves know it
  bool is_lit_from_both_sides;  ///< `double_illuminate`
  bool is_hollow;               ///< media around it fill it too
  std::uint32_t shape;
  PlacedTexture texture;
  PlacedTexture interior_texture;  ///< of the surface seen from inside, if it differs
  scene::InteriorId interior;      ///< of all of it; parts of a CSG tree may have their own
  std::uint32_t holder;  ///< number of the placed object or union that has that interior; if none has, of the outermost
  const scene::Object* object;  ///< in the database
  scene::Transform world_from_object;
  OriginId origin;
  std::uint32_t light_group;  ///< index into CompiledScene::light_groups, or kNone
  double size = 0;  ///< for a solid or blob: the largest coordinate, in its own space, that its surface is computed
                    ///< from
  Spread spread;    ///< in world space
  /// A blob of which value and gradient of the field are all that shading needs to know of a point. Tracer sets it.
  bool is_told_by_fields = false;
};

struct CompiledScene {
  std::vector<scene::Solid> solids;
  SolidDetails details;  ///< details of the solids
  std::vector<CompiledBlob> blobs;
  scene::CoordinateTextures coordinate_textures;
  std::vector<CsgTree> trees;
  std::vector<scene::Transform> texture_spaces;  ///< world_from_space of each group that hands a pattern down
  std::vector<LightGroup> light_groups;
  std::vector<Instance> instances;
  std::vector<std::uint32_t> listed;  ///< instances that are not in `boxes`: half-spaces, and a few blobs
  BoxTree boxes;                      ///< over all other instances
  Box bounds;                         ///< bounds of all that are no half-spaces
  Box clear_bounds;                   ///< bounds of all that may let light through
  double crowd = 0;                   ///< mean number of their boxes on a line that meets `bounds`
  Charge charge;                      ///< of all this
  /// The reason why the scene takes more memory than the run allows. A scene that is refused, or was stopped while it
  /// was compiled, has no instances.
  std::optional<scene::Refusal> refusal;

  [[nodiscard]] std::size_t grid_bytes() const;
};

struct CompileOptions {
  CellRule cells = CellRule::ranges;
  bool unblended = false;                                                 ///< every blob is drawn unblended
  std::size_t most_grid_bytes = std::numeric_limits<std::size_t>::max();  ///< limit of all grids together
  RunLimits run = {};
};

[[nodiscard]] CompiledScene compile(const scene::Database& database, const CompileOptions& options);

}  // namespace isl::render
