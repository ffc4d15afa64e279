#include "renderer/compiled/compiled_scene.h"

#include "renderer/compiled/clear_instances.h"
#include "renderer/compiled/flattener.h"
#include "renderer/compiled/instance_boxes.h"
#include "renderer/csg/expansion.h"
#include "renderer/csg/shape_size.h"
#include "renderer/csg/spread.h"
#include "renderer/grid/blob_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>

namespace isl::render {
namespace {

void set_spread(const scene::Database& database, const CompiledScene& compiled, Instance& instance) {
  switch (instance.kind) {
    case scene::Object::Kind::group: instance.spread = compiled.trees[instance.shape].spread; break;
    case scene::Object::Kind::blob: instance.size = compiled.blobs[instance.shape].size; break;
    case scene::Object::Kind::solid: instance.size = shape_size(database, instance.kind, instance.shape); break;
  }
  if (instance.kind != scene::Object::Kind::group) instance.spread = spread_of_shape(instance.size);
  if (instance.is_placed) instance.spread = spread_through(instance.world_from_object, instance.spread);
}

/// Bytes of what prepare_details() makes.
std::size_t detail_bytes(const scene::Database& database) {
  std::size_t bytes = 0;
#define ISL_SOLID_DETAIL(word, Type, column) \
  bytes += database.column.size() * sizeof(decltype(SolidDetails::column)::value_type);
#include "renderer/scene/solids.def"
  for (const scene::Polynomial& polynomial : database.polynomials)
    bytes += polynomial.coefficients.size() * sizeof(double);
  for (const scene::Polygon& polygon : database.polygons) bytes += 2 * polygon.points.size() * sizeof(PlanePoint);
  return bytes;
}

/// Compiles step by step, until a step is refused.
class Compiler {
 public:
  Compiler(const scene::Database& database, const CompileOptions& options)
      : database_(database),
        options_(options),
        meter_(options.run),
        expansion_(database),
        grids_(options.most_grid_bytes) {
    scene_.charge = meter_.new_charge();
  }

  CompiledScene run() {
    take_solids();
    if (meter_.goes_on()) flatten();
    if (meter_.goes_on() && !refusal_) compile_blobs();
    if (meter_.goes_on() && !refusal_) {
      for (Instance& instance : scene_.instances) set_spread(database_, scene_, instance);
      part_clear_from_opaque(database_, scene_);
      at_ = most_placed_at_;
      wanted_ = [this] { return fmt::format("the boxes over {:.4g} objects, most of them placed here,", placed_); };
      build_instance_boxes(scene_, meter_);
      hold(scene_.boxes.bytes());
    }
    if (meter_.goes_on() && !refusal_) return std::move(scene_);
    CompiledScene none;
    none.refusal = refusal_;
    if (meter_.is_refused()) none.refusal = refusal();
    return none;
  }

 private:
  bool hold(std::size_t bytes) { return meter_.grow(scene_.charge, bytes); }

  [[nodiscard]] scene::Refusal refusal() const {
    return {fmt::format("{} would take more memory than the limit of {:.3g} GB leaves", wanted_(),
                        static_cast<double>(meter_.run().budget->limit()) * 1e-9),
            "`--max-memory` raises the limit", at_};
  }

  void take_solids() {
    wanted_ = [this] { return fmt::format("the {} solids up to here", database_.solids.size()); };
    if (!database_.objects.empty()) at_ = database_.objects.back().origin;
    // A scene of one sphere takes a node of boxes and a few small lists.
    constexpr std::size_t kLeast = sizeof(CompiledScene) + 2048;
    if (!hold(kLeast + database_.solids.size() * sizeof(scene::Solid) + detail_bytes(database_))) return;
    scene_.solids = database_.solids;
    scene_.details = prepare_details(database_);
    scene_.coordinate_textures = scene::CoordinateTextures(database_);
  }

  /// The instances are counted first, so that nothing is expanded that is too much.
  void flatten() {
    wanted_ = [this] { return fmt::format("the {:.4g} objects placed up to here", placed_); };
    double most = 0, visits = 0;
    for (const scene::Object& object : database_.objects) {
      at_ = object.origin;
      const double more = expansion_.instances(object, false);
      placed_ += more;
      if (more > most) most_placed_at_ = object.origin;
      most = std::max(most, more);
      const double bytes = more * sizeof(Instance);
      constexpr double kMost = 0x1p62;
      if (!hold(static_cast<std::size_t>(std::min(bytes, kMost)))) break;
      visits += expansion_.visits(object, false);
      const auto most_steps = static_cast<double>(options_.run.steps_at_point);
      if (visits > most_steps && !refusal_) {
        refusal_ = {
            fmt::format("the objects up to here, with the unions around them, take more than {:g} steps to place",
                        most_steps),
            "`--max-turns` raises the limit", at_};
      }
    }
    if (!meter_.goes_on() || refusal_) return;
    scene_.instances.reserve(static_cast<std::size_t>(placed_));
    Flattener flattener(database_, expansion_, meter_, scene_);
    wanted_ = [this] { return fmt::format("the {:.4g} parts of this object", parts_); };
    for (const scene::Object& object : database_.objects) {
      at_ = object.origin;
      const Expansion::Size size = expansion_.tree_of(object);
      parts_ = size.leaves + size.groups;
      flattener.add(object);
      if (!meter_.goes_on()) break;
    }
    flattener.finish();
  }

  /// A blob that is declared and never placed costs nothing.
  void compile_blobs() {
    std::vector<OriginId> used_at(database_.blobs.size());
    std::vector<bool> is_used(database_.blobs.size(), false);
    const auto use = [&](std::uint32_t blob, OriginId origin) {
      if (!is_used[blob]) used_at[blob] = origin;
      is_used[blob] = true;
    };
    std::vector<OriginId> tree_used_at(scene_.trees.size());
    for (const Instance& instance : scene_.instances) {
      if (instance.kind == scene::Object::Kind::blob) use(instance.shape, instance.origin);
      if (instance.kind == scene::Object::Kind::group) tree_used_at[instance.shape] = instance.origin;
    }
    for (std::size_t i = 0; i < scene_.trees.size(); ++i) {
      for (const CsgLeaf& leaf : scene_.trees[i].leaves) {
        if (leaf.kind == scene::Object::Kind::blob) use(leaf.shape, tree_used_at[i]);
      }
    }
    scene_.blobs.resize(database_.blobs.size());
    for (std::uint32_t i = 0; i < database_.blobs.size() && meter_.goes_on(); ++i) {
      at_ = used_at[i];
      if (is_used[i]) compile_blob(i);
    }
  }

  void compile_blob(std::uint32_t i) {
    CompiledBlob& blob = scene_.blobs[i];
    const scene::Blob& record = database_.blobs[i];
    wanted_ = [&record] { return fmt::format("the {} components of this blob", record.components.size()); };
    Charge working = meter_.new_charge();
    if (!meter_.grow(working, most_table_bytes(record))) return;
    blob.size = shape_size(database_, scene::Object::Kind::blob, i);
    blob.components = compile_components(database_, record, options_.unblended);
    working = meter_.new_charge();
    if (!hold(blob.components.bytes())) return;
    wanted_ = [&record] { return fmt::format("the grid of this blob of {} components", record.components.size()); };
    blob.grid = build_blob_grid(blob.components, options_.cells, grids_, &meter_);
    hold(blob.grid.bytes());
  }

  const scene::Database& database_;
  const CompileOptions& options_;
  Meter meter_;
  Expansion expansion_;
  GridBudget grids_;
  CompiledScene scene_;
  double placed_ = 0;                      ///< instances that the objects make, as far as they are counted
  double parts_ = 0;                       ///< of the object that is being flattened, groups included
  OriginId most_placed_at_{};              ///< the statement that places more objects than any other
  std::optional<scene::Refusal> refusal_;  ///< for its steps
  OriginId at_{};                          ///< the statement whose object is being compiled
  std::function<std::string()> wanted_;    ///< names what asks for memory
};

}  // namespace

std::size_t CompiledScene::grid_bytes() const {
  std::size_t bytes = boxes.bytes();
  for (const CompiledBlob& blob : blobs) bytes += blob.grid.bytes() + blob.components.bytes();
  for (const CsgTree& tree : trees) bytes += tree.bytes();
  return bytes;
}

CompiledScene compile(const scene::Database& database, const CompileOptions& options) {
  return Compiler(database, options).run();
}

}  // namespace isl::render
