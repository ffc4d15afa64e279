// A hit as shading sees it: position, normal, and the textures with their shares.
#pragma once

#include "renderer/scene/ids.h"
#include "renderer/scene/objects.h"
#include "renderer/scene/transform.h"

#include <cstdint>
#include <vector>

namespace isl::render {

using scene::Vec3;

/// The place on a shape from which the surface coordinates (u, v) of a point follow.
struct SurfacePlace {
  scene::Object::Kind kind = scene::Object::Kind::solid;  ///< solid or blob
  std::uint32_t shape = scene::kNone;                     ///< index into the database's solids or blobs
  std::uint32_t component = 0;                            ///< for a blob: index into its components
  Vec3 point{0};                                          ///< in the shape's space
};

/// The space that a texture lives in, for normals: inside the world there may be a space, and another within that.
struct TextureFrame {
  const scene::Transform* outer = nullptr;  ///< world_from_outer; null: the world itself
  const scene::Transform* inner = nullptr;  ///< outer_from_inner; null: the outer space itself

  [[nodiscard]] bool is_world() const { return outer == nullptr && inner == nullptr; }
  /// A vector, from the world to the texture's space.
  [[nodiscard]] Vec3 enter_vector(Vec3 vector) const {
    if (outer) vector = outer->inverse_vector(vector);
    return inner ? inner->inverse_vector(vector) : vector;
  }
  /// A normal, from the world to the texture's space and back; lengths change.
  [[nodiscard]] Vec3 enter(Vec3 normal) const {
    if (outer) normal = outer->inverse_normal(normal);
    return inner ? inner->inverse_normal(normal) : normal;
  }
  [[nodiscard]] Vec3 leave(Vec3 normal) const {
    if (inner) normal = inner->normal(normal);
    return outer ? outer->normal(normal) : normal;
  }
};

/// A texture and its share of the material at a point; the shares of a point add up to one. Components of a blob that
/// have the same texture share one entry, unless the texture asks where on each component the point is.
struct TextureShare {
  scene::TextureId texture;
  double weight;
  Vec3 place{0};         ///< the point, in the space that the texture lives in
  TextureFrame frame{};  ///< that space
  SurfacePlace surface{};
};

/// A body is bounded by all surfaces whose interior comes from the same object, group or part of a combination, as in
/// POV-Ray: the children of a union that has an interior bound one body. All parts of an object without an interior
/// bound one body, too.
struct BodyId {
  std::uint32_t holder = 0;  ///< Instance::holder
  std::uint32_t part = 0;    ///< CsgLeaf::holder

  friend bool operator==(const BodyId&, const BodyId&) = default;
};

struct SurfacePoint {
  Vec3 position;
  Vec3 normal;                                      ///< outward, unit length, in world space
  bool is_lit_from_both_sides = false;              ///< the object has `double_illuminate`
  bool is_hollow = false;                           ///< media around the object fill it too
  scene::InteriorId interior = scene::kNoInterior;  ///< the medium on the inner side
  BodyId body;                                      ///< what the surface bounds
  bool is_refuted = false;                          ///< a check shows that no surface lies here, within the tolerance
  std::vector<TextureShare> textures;  ///< never empty; reused by the caller, so that nothing is allocated per point
};

}  // namespace isl::render
