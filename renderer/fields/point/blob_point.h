// Gradient and texture shares of a blob at a point, for shading.
#pragma once

#include "renderer/rays/surface_point.h"
#include "renderer/scene/coordinate_textures.h"

#include <cstdint>
#include <vector>

namespace isl::render {

/// Weighted textures and the gradient of a blob at a point.
struct BlobPoint {
  double value = 0;  ///< Σfᵢ
  Vec3 gradient{0};  ///< ∇F, in the blob's space
  /// Σ|fᵢ| by texture, not normalised; kNoTexture stands for the blob's own texture. In each share's `surface` only the
  /// component is set.
  std::vector<TextureShare> shares;
  std::uint64_t evaluations = 0;  ///< number of fields evaluated for this point
};

/// Tells whether components with the same texture may be merged into one share: not if the texture depends on each
/// component's own coordinates.
struct ShareRule {
  const scene::CoordinateTextures* coordinate_textures;
  scene::TextureId other;  ///< the texture for which kNoTexture stands

  [[nodiscard]] bool may_share(scene::TextureId texture) const {
    return !coordinate_textures->has(texture == scene::kNoTexture ? other : texture);
  }
};

}  // namespace isl::render
