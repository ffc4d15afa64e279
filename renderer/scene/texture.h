// What surfaces look like: the record that objects and components refer to.
//
// A texture lives in the space of the object that names it, before that object's transform: so what is moved after it
// was given takes it along and no record changes. A texture given after a transform is moved back by it when it is
// read. The texture of a blob's component lives in the blob's space. A plain colour is the same everywhere, and none of
// this concerns it.
#pragma once

#include "renderer/scene/finish.h"
#include "renderer/scene/ids.h"
#include "renderer/scene/normal.h"
#include "renderer/scene/pigment.h"

#include <cstdint>
#include <vector>

namespace isl::scene {

/// Either a pigment with a normal and a finish, or (`pattern`) a choice of other textures. Equal ones share a record:
/// comparable byte by byte once its places are taken away (without_places).
struct Texture {
  Pigment pigment{};
  NormalId normal = kNoNormal;
  FinishId finish = kDefaultFinish;              ///< kDefaultFinish: Finish{}
  TexturePatternId pattern = kNoTexturePattern;  ///< else pigment, normal and finish say nothing
  TextureId below = kNoTexture;                  ///< the layer under this one
  std::uint32_t uv_mapping = 0;                  ///< 1: pigment and normal are evaluated at (u, v, 0) of the surface
  OriginId named_at{};           ///< where the scene names the declared texture that it is, if it is one

  /// The same at every point of a surface, but for what the light does.
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
  double value = 0;  ///< as PigmentEntry's; of a material_map the index
  TextureId texture = kNoTexture;
};
using TextureMap = std::vector<TextureEntry>;

/// A texture that is chosen from others by a pattern.
struct TexturePattern {
  Pattern pattern{};
  TextureMapId map = kNoTextureMap;
};

}  // namespace isl::scene
