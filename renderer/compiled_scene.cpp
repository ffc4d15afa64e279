#include "renderer/compiled_scene.h"

#include "renderer/grid/blob_grid.h"
#include "renderer/grid/instance_grid.h"

namespace isl::render {
namespace {

/// Walks the tree of objects, composing transforms and handing textures down.
class Flattener {
 public:
  Flattener(const scene::Database& database, CompiledScene& compiled) : database_(database), compiled_(compiled) {}

  void add(const scene::Object& object, const scene::Transform& world_from_parent, scene::TextureId inherited, bool no_shadow) {
    const scene::Transform world_from_object = then(object.parent_from_object, world_from_parent);
    const scene::TextureId texture = object.texture == scene::kNoTexture ? inherited : object.texture;
    no_shadow = no_shadow || object.no_shadow;
    if (object.kind == scene::Object::Kind::group) {
      for (const scene::Object& child : database_.groups[object.shape].children) {
        add(child, world_from_object, texture, no_shadow);
      }
      return;
    }
    const bool is_placed = world_from_object.matrix != scene::Matrix();
    compiled_.instances.push_back(
        {object.kind, no_shadow, is_placed, object.shape, texture, world_from_object, object.origin});
  }

 private:
  const scene::Database& database_;
  CompiledScene& compiled_;
};

}  // namespace

std::size_t CompiledScene::grid_bytes() const {
  std::size_t bytes = grid.bytes();
  for (const CompiledBlob& blob : blobs) bytes += blob.grid.bytes() + blob.components.bytes();
  return bytes;
}

CompiledScene compile(const scene::Database& database, const CompileOptions& options) {
  CompiledScene compiled;
  compiled.solids = database.solids;
  Flattener flattener(database, compiled);
  for (const scene::Object& object : database.objects) flattener.add(object, {}, scene::kNoTexture, false);

  // A blob that is declared and never placed costs nothing.
  std::vector<bool> is_used(database.blobs.size(), false);
  for (const Instance& instance : compiled.instances) {
    if (instance.kind == scene::Object::Kind::blob) is_used[instance.shape] = true;
  }
  compiled.blobs.resize(database.blobs.size());
  for (std::size_t i = 0; i < database.blobs.size(); ++i) {
    if (!is_used[i]) continue;
    compiled.blobs[i].components = compile_components(database, database.blobs[i], options.skeleton);
    compiled.blobs[i].grid = build_blob_grid(compiled.blobs[i].components, {.classify = options.classify_cells});
  }
  build_instance_grid(compiled);
  return compiled;
}

}  // namespace isl::render
