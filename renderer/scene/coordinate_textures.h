// Finds the textures that use surface coordinates (`uv_mapping`) and not only the point in space.
#pragma once

#include "renderer/scene/database.h"

#include <vector>

namespace isl::scene {

class CoordinateTextures {
 public:
  CoordinateTextures() = default;
  explicit CoordinateTextures(const Database& database);

  /// True if the texture, a layer of it or any record that it refers to has `uv_mapping`. kNoTexture stands for the
  /// scene's default texture.
  [[nodiscard]] bool has(TextureId id) const { return any_ && (id == kNoTexture ? asks_.back() : asks_[index(id)]); }

 private:
  bool any_ = false;
  std::vector<bool> asks_;  ///< one per texture, then the default's; empty unless any_
};

}  // namespace isl::scene
