// What stands where.
#pragma once

#include "base/source_span.h"
#include "renderer/scene/ids.h"
#include "renderer/scene/transform.h"

#include <cstdint>
#include <vector>

namespace isl::scene {

/// Something placed: a shape and where it stands. Shapes are shared; placing one again costs an Object.
struct Object {
  enum class Kind : std::uint8_t { solid, blob, group };
  Kind kind = Kind::solid;
  bool no_shadow = false;
  std::uint32_t shape = kNone;     ///< index into solids, blobs or groups
  Transform parent_from_object{};  ///< into the group that holds it, or the world
  TextureId texture = kNoTexture;  ///< kNoTexture: the group's, in the end the scene's default
  TextureId interior_texture = kNoTexture;  ///< of the inside of the surface; kNoTexture: `texture`
  InteriorId interior = kNoInterior;        ///< kNoInterior: the group's, in the end none
  OriginId origin{};
};

/// A union: children with their own textures and transforms. Children are whole objects, so that a group is
/// self-contained.
struct Group {
  std::vector<Object> children;
};

}  // namespace isl::scene
