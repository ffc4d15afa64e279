#include "renderer/scene/coordinate_textures.h"

#include "renderer/scene/edges.h"
#include "renderer/scene/remembered.h"

#include <algorithm>
#include <cstdint>

namespace isl::scene {
namespace {

/// A record uses surface coordinates if it has `uv_mapping` or refers to a record that uses them. Each record is
/// visited once. References have no cycles, since a record is made after those that it refers to.
class Walk {
 public:
  explicit Walk(const Database& database)
      : database_(database),
        textures_(database.textures.size()),
        pigments_(database.pigments.size()),
        normals_(database.normals.size()) {}

  bool asks(const Texture& texture) { return texture.uv_mapping != 0 || edge_asks(texture); }

  bool asks(TextureId id) {
    return id != kNoTexture && remembered(textures_[index(id)], [&] { return asks(database_.textures[index(id)]); });
  }

 private:
  template <class Record>
  bool edge_asks(const Record& record) {
    bool found = false;
    for_each_edge(record, [&](const auto& id) { found = found || asks(id); });
    return found;
  }

  /// A record with a pattern.
  template <class Record>
  bool patterned_asks(const Record& record) {
    return record.pattern.uv_mapping || edge_asks(record);
  }

  bool asks(PigmentId id) {
    return id != kPlainColour &&
           remembered(pigments_[index(id)], [&] { return patterned_asks(database_.pigments[index(id)]); });
  }
  bool asks(NormalId id) {
    return id != kNoNormal &&
           remembered(normals_[index(id)], [&] { return patterned_asks(database_.normals[index(id)]); });
  }
  bool asks(TexturePatternId id) {
    return id != kNoTexturePattern && patterned_asks(database_.texture_patterns[index(id)]);
  }
  bool asks(TextureMapId id) { return id != kNoTextureMap && edge_asks(database_.texture_maps[index(id)]); }
  bool asks(PigmentMapId id) { return id != kNoPigmentMap && edge_asks(database_.pigment_maps[index(id)]); }
  bool asks(NormalMapId id) { return id != kNoNormalMap && edge_asks(database_.normal_maps[index(id)]); }
  /// Finishes, transforms, images, functions and the objects of patterns do not use surface coordinates.
  template <class Id>
  bool asks(Id /*id*/) {
    return false;
  }

  const Database& database_;
  std::vector<Answer> textures_, pigments_, normals_;
};

}  // namespace

CoordinateTextures::CoordinateTextures(const Database& database) {
  Walk walk(database);
  asks_.reserve(database.textures.size() + 1);
  for (std::uint32_t i = 0; i < database.textures.size(); ++i) asks_.push_back(walk.asks(TextureId{i}));
  asks_.push_back(walk.asks(database.default_texture));
  any_ = std::ranges::find(asks_, true) != asks_.end();
  if (!any_) asks_.clear();
}

}  // namespace isl::scene
