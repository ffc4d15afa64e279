#include "renderer/compiled/compiled_scene.h"

#include "renderer/compiled/instance_grid.h"
#include "renderer/csg/csg_builder.h"
#include "renderer/csg/shape_size.h"
#include "renderer/csg/spread.h"
#include "renderer/grid/blob_grid.h"
#include "renderer/rays/ray.h"

namespace isl::render {
namespace {

/// The kinds of rays that an object is hidden from, as bits.
unsigned hidden_from(const scene::Object& object) {
  const auto bit = [](bool is_hidden, RayKind kind) { return is_hidden ? static_cast<unsigned>(kind) : 0; };
  return bit(object.no_image, RayKind::image) | bit(object.no_reflection, RayKind::reflection) |
         bit(object.no_shadow, RayKind::shadow);
}

/// Walks the tree of objects, composing transforms and handing textures down. The unions that are open are a list
/// instead of recursion, so that depth costs no stack.
class Flattener {
 public:
  Flattener(const scene::Database& database, CompiledScene& compiled)
      : database_(database), compiled_(compiled), csg_(database) {}

  /// State that an object hands down to its children.
  struct Inherited {
    scene::Transform world_from_parent{};
    scene::TextureId texture = scene::kNoTexture;
    TextureSpace texture_space = kOuterSpace;
    std::uint8_t hidden_from = 0;
    bool is_inverse = false;
  };

  /// Adds an object of the world.
  void add(const scene::Object& object) {
    add(object, {});
    while (!open_.empty()) {
      OpenUnion& innermost = open_.back();
      if (innermost.next == innermost.children->size()) {
        open_.pop_back();
      } else {
        const scene::Object& child = (*innermost.children)[innermost.next++];
        add(child, Inherited(innermost.own));  // a copy, because opening the child moves the list
      }
    }
  }

  void finish() { compiled_.trees = csg_.take_trees(); }

 private:
  struct OpenUnion {
    const std::vector<scene::Object>* children;
    Inherited own;
    std::size_t next = 0;
  };

  /// Makes the object's instance, or opens it if it is a union.
  void add(const scene::Object& object, const Inherited& above) {
    Inherited own{then(object.parent_from_object, above.world_from_parent), above.texture, above.texture_space,
                  static_cast<std::uint8_t>(above.hidden_from | hidden_from(object)),
                  above.is_inverse != object.inverse};
    const bool is_csg = needs_csg(database_, object, above.is_inverse);
    const bool is_union = object.kind == scene::Object::Kind::group && !is_csg;
    if (object.texture != scene::kNoTexture) {
      own.texture = object.texture;
      own.texture_space = kOwnSpace;
      if (is_union && !database_.texture(object.texture).is_plain()) {
        own.texture_space = static_cast<TextureSpace>(compiled_.texture_spaces.size());
        compiled_.texture_spaces.push_back(own.world_from_parent);
      }
    }
    if (is_union) {
      open_.push_back({&database_.groups[object.shape].children, own});
      return;
    }
    const bool is_placed = own.world_from_parent.matrix != scene::Matrix();
    compiled_.instances.push_back({is_csg ? scene::Object::Kind::group : object.kind,
                                   own.hidden_from,
                                   is_placed,
                                   own.is_inverse && !is_csg,
                                   is_csg ? csg_.tree_of(object, above.is_inverse) : object.shape,
                                   own.texture,
                                   own.texture_space,
                                   own.world_from_parent,
                                   object.origin,
                                   0,
                                   {}});
  }

  const scene::Database& database_;
  CompiledScene& compiled_;
  CsgBuilder csg_;
  std::vector<OpenUnion> open_;
};

void set_spread(const scene::Database& database, const CompiledScene& compiled, Instance& instance) {
  switch (instance.kind) {
    case scene::Object::Kind::group: instance.spread = compiled.trees[instance.shape].spread; break;
    case scene::Object::Kind::blob: instance.size = compiled.blobs[instance.shape].size; break;
    case scene::Object::Kind::solid: instance.size = shape_size(database, instance.kind, instance.shape); break;
  }
  if (instance.kind != scene::Object::Kind::group) instance.spread = spread_of_shape(instance.size);
  if (instance.is_placed) instance.spread = spread_through(instance.world_from_object, instance.spread);
}

}  // namespace

std::size_t CompiledScene::grid_bytes() const {
  std::size_t bytes = grid.bytes();
  for (const CompiledBlob& blob : blobs) bytes += blob.grid.bytes() + blob.components.bytes();
  for (const CsgTree& tree : trees) bytes += tree.bytes();
  return bytes;
}

CompiledScene compile(const scene::Database& database, const CompileOptions& options) {
  CompiledScene compiled;
  compiled.solids = database.solids;
  compiled.details = prepare_details(database);
  compiled.coordinate_textures = scene::CoordinateTextures(database);
  Flattener flattener(database, compiled);
  for (const scene::Object& object : database.objects) flattener.add(object);
  flattener.finish();

  // A blob that is declared and never placed costs nothing.
  std::vector<bool> is_used(database.blobs.size(), false);
  for (const Instance& instance : compiled.instances) {
    if (instance.kind == scene::Object::Kind::blob) is_used[instance.shape] = true;
  }
  for (const CsgTree& tree : compiled.trees) {
    for (const CsgLeaf& leaf : tree.leaves) {
      if (leaf.kind == scene::Object::Kind::blob) is_used[leaf.shape] = true;
    }
  }
  GridBudget budget(options.most_grid_bytes);
  compiled.blobs.resize(database.blobs.size());
  for (std::size_t i = 0; i < database.blobs.size(); ++i) {
    if (!is_used[i]) continue;
    compiled.blobs[i].size = shape_size(database, scene::Object::Kind::blob, static_cast<std::uint32_t>(i));
    compiled.blobs[i].components = compile_components(database, database.blobs[i], options.unblended);
    compiled.blobs[i].grid = build_blob_grid(compiled.blobs[i].components, options.cells, budget);
  }
  for (Instance& instance : compiled.instances) set_spread(database, compiled, instance);
  build_instance_grid(compiled, budget);
  return compiled;
}

}  // namespace isl::render
