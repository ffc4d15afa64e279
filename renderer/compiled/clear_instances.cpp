#include "renderer/compiled/clear_instances.h"

#include "renderer/rays/ray.h"
#include "renderer/scene/clear_textures.h"
#include "renderer/scene/remembered.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace isl::render {
namespace {

/// Looks at each blob and each tree once.
class ClearInstances {
 public:
  ClearInstances(const scene::Database& database, const CompiledScene& scene)
      : database_(database),
        scene_(scene),
        textures_(database),
        blobs_(scene.blobs.size()),
        trees_(scene.trees.size()) {}

  /// True if some point of the instance may let light through.
  bool has(const Instance& instance) {
    if (!textures_.any()) return false;
    if (textures_.has(instance.texture.id)) return true;
    if (is_clear(instance.interior_texture.id)) return true;
    switch (instance.kind) {
      case scene::Object::Kind::solid: return false;
      case scene::Object::Kind::blob: return is_clear_blob(instance.shape);
      case scene::Object::Kind::group: break;
    }
    return scene::remembered(trees_[instance.shape], [&] {
      return std::ranges::any_of(scene_.trees[instance.shape].leaves, [&](const CsgLeaf& leaf) {
        return is_clear(leaf.texture.id) || is_clear(leaf.interior_texture.id) ||
               (leaf.kind == scene::Object::Kind::blob && is_clear_blob(leaf.shape));
      });
    });
  }

 private:
  /// True of a texture of a part alone, if the part has one.
  [[nodiscard]] bool is_clear(scene::TextureId id) const { return id != scene::kNoTexture && textures_.has(id); }

  bool is_clear_blob(std::uint32_t shape) {
    return scene::remembered(blobs_[shape], [&] {
      return std::ranges::any_of(database_.blobs[shape].components,
                                 [&](const scene::Component& component) { return is_clear(component.texture); });
    });
  }

  const scene::Database& database_;
  const CompiledScene& scene_;
  scene::ClearTextures textures_;
  std::vector<scene::Answer> blobs_, trees_;
};

}  // namespace

void part_clear_from_opaque(const scene::Database& database, CompiledScene& scene) {
  ClearInstances clear(database, scene);
  for (Instance& instance : scene.instances) instance.hidden_from |= clear.has(instance) ? kOnlyOpaque : kOnlyClear;
}

}  // namespace isl::render
