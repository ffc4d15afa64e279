// Gradient and texture shares of a blob at a point, for shading.
#pragma once

#include "renderer/rays/blob_fields.h"
#include "renderer/rays/surface_point.h"
#include "renderer/scene/coordinate_textures.h"

#include <cstdint>
#include <vector>

namespace isl::render {

/// A point where a blob's fields are asked for, in the blob's space, and the cell of its grid that lists them.
struct FieldQuery {
  Vec3 point;
  std::uint32_t cell;
};

/// The fields of a blob at a point, and its textures with their weights.
struct BlobPoint {
  BlobFields fields;
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
