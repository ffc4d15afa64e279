// What the language asks about objects while a scene is evaluated: `trace`, `inside`, `min_extent`, `max_extent`. The
// renderer answers (renderer/queries/), the interpreter asks, and cli makes them known to one another.
#pragma once

#include "renderer/scene/database.h"

#include <ImathBox.h>

#include <optional>

namespace isl::scene {

/// Where a ray meets an object first.
struct TracedPoint {
  Vec3 position;
  Vec3 normal;  ///< towards where the ray came from or away from it: outward, unit length
};

/// Objects lie in the space that they are placed into. Between questions the database may grow; what it holds already
/// stays as it is, so that a shape is made ready once.
class Queries {
 public:
  virtual ~Queries() = default;

  /// The first surface along the ray beyond its origin, whatever the object's flags; none for a miss and for a
  /// direction of length zero.
  [[nodiscard]] virtual std::optional<TracedPoint> trace(const Database& database, const Object& object,
                                                         const Vec3& origin, const Vec3& direction) = 0;
  /// A point on the surface counts as inside. Flat pieces have no inside.
  [[nodiscard]] virtual bool inside(const Database& database, const Object& object, const Vec3& point) = 0;
  /// Holds the surface; empty where there is none, with infinite sides where it has no end or none is known.
  [[nodiscard]] virtual Imath::Box3d extent(const Database& database, const Object& object) = 0;
};

}  // namespace isl::scene
