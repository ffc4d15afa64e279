// Finds the textures that may let light through, so that shadow rays need not ask the others what passes them.
#pragma once

#include "renderer/scene/database.h"

#include <vector>

namespace isl::scene {

class ClearTextures {
 public:
  ClearTextures() = default;
  explicit ClearTextures(const Database& database);

  /// False if no point of the texture lets light through. kNoTexture stands for the scene's default texture.
  [[nodiscard]] bool has(TextureId id) const {
    return any_ && (id == kNoTexture ? is_clear_.back() : is_clear_[index(id)]);
  }
  [[nodiscard]] bool any() const { return any_; }

 private:
  bool any_ = false;
  std::vector<bool> is_clear_;  ///< one per texture, then the default's; empty unless any_
};

}  // namespace isl::scene
