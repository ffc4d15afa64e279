// Which textures ask where on the surface a point is (`uv_mapping`), rather than where in space.
#pragma once

#include "renderer/scene/database.h"

#include <vector>

namespace isl::scene {

class CoordinateTextures {
 public:
  CoordinateTextures() = default;
  explicit CoordinateTextures(const Database& database);

  /// Whether the texture, a layer of it or anything that it is chosen or made from has `uv_mapping`. kNoTexture: the
  /// scene's default texture.
  [[nodiscard]] bool has(TextureId id) const { return any_ && (id == kNoTexture ? asks_.back() : asks_[index(id)]); }

 private:
  bool any_ = false;
  std::vector<bool> asks_;  ///< one a texture, then the default; empty unless any_
};

}  // namespace isl::scene
