// What stands where.
#pragma once

#include "base/source_span.h"
#include "renderer/scene/ids.h"
#include "renderer/scene/light.h"
#include "renderer/scene/transform.h"

#include <cstdint>
#include <vector>

namespace isl::scene {

/// Items whose places are kept.
enum class ObjectItem : std::uint8_t { no_image, no_reflection, double_illuminate, interior_texture, count };

/// Something placed: a shape and where it stands. Shapes are shared; placing one again costs an Object. Of a group,
/// what is said here holds for every child too.
struct Object {
  enum class Kind : std::uint8_t { solid, blob, group };
  Kind kind = Kind::solid;
  bool no_shadow = false;
  bool no_image = false;                    ///< not seen by the camera, only in reflections and through what refracts
  bool no_reflection = false;               ///< not seen in reflections
  bool double_illuminate = false;           ///< light from behind lights the surface too
  bool hollow = false;                      ///< fog and the like fill its inside
  bool inverse = false;                     ///< its inside is its outside
  std::uint32_t shape = kNone;              ///< index into solids, blobs or groups
  Transform parent_from_object{};           ///< into the group that holds it, or the world
  TextureId texture = kNoTexture;           ///< kNoTexture: the group's, in the end the scene's default
  TextureId interior_texture = kNoTexture;  ///< of the surface seen from inside; kNoTexture: `texture`
  InteriorId interior = kNoInterior;        ///< kNoInterior: the group's
  /// Only what lies in every child of this intersection is there. In the object's space, before parent_from_object.
  GroupId clip = kNoGroup;
  /// The same for what the scene promises to hold the object (`bounded_by`).
  GroupId bound = kNoGroup;
  SaidAt<ObjectItem> said_at{};
  OriginId origin{};
};

/// How a group's children make one solid. `subtract`: the first without the others. `merge` is a union without the
/// surfaces inside.
enum class Operation : std::uint8_t { unite, merge, intersect, subtract };

/// Children with their own textures and transforms. They are whole objects, so that a group is self-contained.
struct Group {
  Operation operation = Operation::unite;
  bool cutaway_textures = false;  ///< children without a texture take that of the child they cut
  bool is_light_group = false;    ///< `lights` shine on the children only
  bool global_lights = false;     ///< of a light group: the scene's lights shine on the children too
  std::vector<Object> children{};
  std::vector<Light> lights{};  ///< of a light group, in the group's space
};

}  // namespace isl::scene
