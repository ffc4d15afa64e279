// The roots of F along a ray, by proof: a stretch is decided only when an enclosure of F excludes zero, or when F is
// monotone there and its signs at the ends are certain; otherwise it is divided. The search goes from front to back and
// ends behind the first crossing, or where the ray's bound of steps is spent.
//
// Cases that the digits at hand cannot decide (a surface touched to 1e-18) are reported as a touch, never guessed.
#pragma once

#include "renderer/extended/field_on_ray.h"

#include <optional>
#include <vector>

namespace isl::ISL_EXTENDED {

/// A stretch on which the sign of F is lost in rounding, with the same sign on both sides (or the ray's start on one).
struct Touch {
  Real begin = 0, end = 0;
};

/// A stretch on which F rises or falls strictly and changes sign.
struct Bracket {
  Real begin, end;
};

struct FirstRoot {
  bool starts_inside = false;      ///< F > 0 just after t = 0
  std::optional<Real> crossing;    ///< the first t at which F changes sign, 0 < t < t_max
  Real slack = 0;                  ///< it lies within this of `crossing`: there the sign of F is lost in rounding
  std::optional<Bracket> bracket;  ///< the crossing's, unless it lies in a stretch where the sign is lost
  std::vector<Touch> touches;      ///< before the crossing
};

struct RootOptions {
  Real t_max = kInfiniteReal;
  /// The origin is on the surface: the level set through it is searched, and its known root at t = 0 is left out.
  bool starts_on_root = false;
  int coming_from = 0;  ///< the sign of F before the origin, if it is known: it tells a crossing there from a touch
  Real enough = 0;      ///< a crossing need not be known better than this, in units of t
};

/// The answer means nothing once field.is_spent().
[[nodiscard]] FirstRoot first_root(FieldOnRay& field, const RootOptions& options);

/// The crossing in a bracket, before which F has the sign `sign0`, from a first guess; known as well as is `enough`.
[[nodiscard]] Real crossing_in(const FieldOnRay& field, const Bracket& bracket, Real guess, int sign0, Real enough);

}  // namespace isl::ISL_EXTENDED
