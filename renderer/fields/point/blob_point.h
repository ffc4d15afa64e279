// Gradient and texture shares of a blob at a point, as shading needs them.
#pragma once

#include "renderer/rays/surface_point.h"
#include "renderer/scene/coordinate_textures.h"

#include <cstdint>
#include <vector>

namespace isl::render {

/// Weighted textures and the gradient of a blob at a point: what shading needs.
struct BlobPoint {
  Vec3 gradient{0};  ///< of F, in the blob's space
  /// |fᵢ| by texture, not normalised; kNoTexture stands for the blob's own. Of each place the component is set.
  std::vector<TextureShare> shares;
  std::uint64_t evaluations = 0;  ///< of fields, for this point
};

/// Which components of a blob may share their texture: not those that look it up in places of their own.
struct ShareRule {
  const scene::CoordinateTextures* coordinate_textures;
  scene::TextureId other;  ///< what kNoTexture stands for

  [[nodiscard]] bool may_share(scene::TextureId texture) const {
    return !coordinate_textures->has(texture == scene::kNoTexture ? other : texture);
  }
};

}  // namespace isl::render
