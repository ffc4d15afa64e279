// The interface for the language's functions of objects, which are called while a scene is evaluated: `trace`,
// `inside`, `min_extent`, `max_extent`. The renderer implements it (renderer/queries/), the interpreter calls it, and
// cli connects the two.
#pragma once

#include "renderer/scene/database.h"
#include "renderer/scene/refusal.h"

#include <ImathBox.h>

#include <optional>

namespace isl::scene {

/// The first hit of a ray with an object.
struct TracedPoint {
  Vec3 position;
  Vec3 normal;  ///< outward, unit length; it may point away from the ray's origin
};

struct TraceAnswer {
  std::optional<TracedPoint> point;  ///< nullopt for a miss or a direction of length zero
  bool is_certain = true;            ///< false if no digits at hand decide whether a surface lies before the point
};

/// Points are in the space that the object is placed into. The database may grow between calls, but its records do not
/// change, so that each shape is prepared once.
class Queries {
 public:
  virtual ~Queries() = default;

  /// The first surface along the ray beyond its origin; flags of the object have no effect.
  [[nodiscard]] virtual TraceAnswer trace(const Database& database, const Object& object, const Vec3& origin,
                                          const Vec3& direction) = 0;
  /// A point on the surface counts as inside. Open surfaces have no inside.
  [[nodiscard]] virtual bool inside(const Database& database, const Object& object, const Vec3& point) = 0;
  /// The field of an object that is a blob, without its threshold.
  [[nodiscard]] virtual double field(const Database& database, const Object& object, const Vec3& point) = 0;
  /// A box that contains the surface: empty if there is no surface, with infinite sides if it is infinite or no bound
  /// is known.
  [[nodiscard]] virtual Imath::Box3d extent(const Database& database, const Object& object) = 0;
  /// The reason why an answer could not be found, if the last question has none: it is then meaningless.
  [[nodiscard]] virtual std::optional<Refusal> refusal() const { return std::nullopt; }
};

}  // namespace isl::scene
