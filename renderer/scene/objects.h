// Objects and groups: shapes with their places.
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

/// An instance of a shape. Shapes are shared: a further instance costs one Object. The members of a group's object hold
/// for every child too.
struct Object {
  enum class Kind : std::uint8_t { solid, blob, group };
  Kind kind = Kind::solid;
  bool no_shadow = false;
  bool no_image = false;                    ///< not seen by the camera, only in reflections and through refraction
  bool no_reflection = false;               ///< not seen in reflections
  bool no_radiosity = false;                ///< neither keeps light from around away from others nor gives them some
  bool double_illuminate = false;           ///< light from behind lights the surface too
  bool hollow = false;                      ///< media, such as air, fill its inside
  bool inverse = false;                     ///< inside and outside are exchanged
  std::uint32_t shape = kNone;              ///< index into solids, blobs or groups
  Transform parent_from_object{};           ///< the parent is the group that holds it, or the world
  TextureId texture = kNoTexture;           ///< kNoTexture: the group's; without one, the scene's default
  TextureId interior_texture = kNoTexture;  ///< of the surface seen from inside; kNoTexture: `texture`
  InteriorId interior = kNoInterior;        ///< kNoInterior: the group's
  /// The object is clipped to this intersection, which is in the object's space, before parent_from_object.
  GroupId clip = kNoGroup;
  /// The intersection that the scene gives as a bound of the object (`bounded_by`), in the same space.
  GroupId bound = kNoGroup;
  SaidAt<ObjectItem> said_at{};
  OriginId origin{};
};

/// The set operation of a group's children. `subtract`: the first without the others. `merge`: a union without the
/// surfaces inside.
enum class Operation : std::uint8_t { unite, merge, intersect, subtract };

/// Several objects as one. Children are complete objects with their own textures and transforms, so that a group is
/// self-contained.
struct Group {
  Operation operation = Operation::unite;
  bool cutaway_textures = false;  ///< children without a texture take that of the child that they cut
  bool is_light_group = false;    ///< `lights` shine on the children only
  bool global_lights = false;     ///< light group: the scene's lights shine on the children too
  std::vector<Object> children{};
  std::vector<Light> lights{};  ///< of a light group; in the group's space
};

}  // namespace isl::scene
