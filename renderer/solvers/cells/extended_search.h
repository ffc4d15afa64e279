// The last resort of the certified solver: a stretch of a ray that double precision cannot decide is searched again by
// interval arithmetic (renderer/extended), on the same list of components: in long double and, if that does not decide
// it either, with 113 bits. Where even that does not tell the sign, but on no longer a stretch than rounding moves the
// ray's own points, there is no surface: such is the very middle of a hard component. A question ends when the ray's
// steps are spent; it is then open.
#pragma once

#include "renderer/fields/laid_out_fields.h"
#include "renderer/rays/ray_steps.h"

#include <cmath>
#include <optional>

namespace isl::render {

/// A stretch of the ray that `fields` were laid out for.
struct OpenStretch {
  double t0, t1;
  double side;          ///< +1 if the ray comes from outside (F < T), −1 if from inside
  bool starts_on_root;  ///< the ray starts on the surface at t0, and that root is not searched for
};

/// How far rounding moves a point of the ray, along the ray: a coordinate o + td is rounded by half a unit in the last
/// place of its product and of its sum.
[[nodiscard]] inline double rounding_of_places(const scene::Vec3& origin, const scene::Vec3& direction, double t) {
  return 0x1p-52 * (origin.length() / direction.length() + std::abs(t));
}

struct ExtendedAnswer {
  /// If not, F stays within the rounding of all digits at hand on some stretch, or the ray's steps are spent.
  bool is_certain = false;
  std::optional<double> crossing;  ///< the first t in [t0, t1] at which the ray changes sides, if it is certain
};

[[nodiscard]] ExtendedAnswer search_extended(const LaidOutFields& fields, const OpenStretch& stretch, RaySteps& steps);

/// True if F > T at t, false if F < T; nothing if rounding hides which.
[[nodiscard]] std::optional<bool> is_inside(const LaidOutFields& fields, double t, RaySteps& steps);

/// True unless it is certain that F has the same sign all along the ray from t0 to t1.
[[nodiscard]] bool may_cross(const LaidOutFields& fields, double t0, double t1, RaySteps& steps);

}  // namespace isl::render
