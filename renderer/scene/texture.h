// Textures: the appearance of surfaces. Objects and components refer to these records.
//
// A texture is in the space of the object that refers to it, before that object's transform: a transform after the
// texture moves it with the object, and no record changes. A texture after a transform is transformed by the inverse
// when it is read. The texture of a blob's component is in the blob's space. None of this applies to plain colours,
// which are uniform.
#pragma once

#include "renderer/scene/finish.h"
#include "renderer/scene/ids.h"
#include "renderer/scene/normal.h"
#include "renderer/scene/pigment.h"

#include <cstdint>
#include <vector>

namespace isl::scene {

/// Either a pigment with a normal and a finish, or (`pattern`) a choice of other textures. Equal textures share a
/// record: they are compared byte by byte without their places (without_places).
struct Texture {
  Pigment pigment{};
  NormalId normal = kNoNormal;
  FinishId finish = kDefaultFinish;              ///< kDefaultFinish: Finish{}
  TexturePatternId pattern = kNoTexturePattern;  ///< if set, pigment, normal and finish are unused
  TextureId below = kNoTexture;                  ///< the layer under this one
  std::uint32_t uv_mapping = 0;                  ///< 1: pigment and normal are evaluated at (u, v, 0) of the surface
  OriginId named_at{};                           ///< place of the identifier, if the texture is a declared one

  /// True if the texture is the same at every point of a surface.
  [[nodiscard]] bool is_plain() const {
    return pigment.is_plain() && normal == kNoNormal && pattern == kNoTexturePattern && below == kNoTexture;
  }
};

static_assert(sizeof(Texture) == sizeof(Pigment) + 6 * sizeof(std::uint32_t), "no padding");

[[nodiscard]] inline Texture without_places(Texture texture) {
  texture.pigment.said_at = {};
  texture.named_at = {};
  return texture;
}

struct TextureEntry {
  double value = 0;  ///< as PigmentEntry's; for a material_map the index
  TextureId texture = kNoTexture;
};
using TextureMap = std::vector<TextureEntry>;

/// A pattern and the map from which it chooses a texture.
struct TexturePattern {
  Pattern pattern{};
  TextureMapId map = kNoTextureMap;
};

}  // namespace isl::scene
