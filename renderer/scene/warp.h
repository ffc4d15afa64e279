// Transforms and POV-Ray's warps, which move the point at which a pattern is evaluated. renderer/patterns applies them;
// they do not depend on the pattern.
#pragma once

#include "renderer/scene/ids.h"
#include "renderer/scene/transform.h"

#include <cstdint>
#include <variant>

namespace isl::scene {

/// The point is displaced by a sum of `octaves` noises, each `lambda` times finer than the one before, with `omega`
/// times its amplitude.
struct Turbulence {
  Vec3 amount{0};
  int octaves = 6;
  double lambda = 2;
  double omega = 0.5;
};

/// A slice of the pattern, repeated along one axis.
struct RepeatWarp {
  int axis = 0;      ///< 0, 1, 2: x, y, z
  double width = 1;  ///< of the slice; negative if the given direction was
  Vec3 offset{0};    ///< added for each repetition
  Vec3 flip{0};      ///< 1 where every other repetition is mirrored
};

/// Points within the radius are pulled towards the centre, or pushed away from it.
struct BlackHoleWarp {
  Vec3 centre{0};
  double radius = 1;
  double strength = 1;
  double falloff = 2;
  bool inverse = false;
  bool repeats = false;
  Vec3 repeat{0};  ///< size of the repeated block; 0: no repetition along that axis
  bool is_turbulent = false;
  Vec3 turbulence{0};  ///< random offset of the repetitions' centres
};

/// The plane of x and y wrapped around a shape.
struct MappingWarp {
  enum class Shape : std::uint8_t { cylinder, sphere, torus, plane, cube };
  Shape shape = Shape::cylinder;
  Vec3 orientation{0, 0, 1};  ///< plane: its normal
  double distance_exponent = 0;
  double major_radius = 1;  ///< torus
  double distance = 0;      ///< plane: along the normal
};

/// TransformId: the transform of the pattern, as the scene gives it (`scale 2`); the point is transformed by its
/// inverse.
using Warp = std::variant<TransformId, Turbulence, RepeatWarp, BlackHoleWarp, MappingWarp>;

}  // namespace isl::scene
