// The rule by which hits are judged at every scale: a position is right if it is off by at most eight units in the last
// place of its coordinates. Nothing in it is a fraction of the scene's extent: a component that lies elsewhere, however
// large, allows no error here.
//
// Axis by axis, with u = 2⁻⁵², the coordinates at t are those of the ray's origin, of the way t·d, and of the
// components that have a field there; the field of component i changes by at most 8u Σ|∂fᵢ/∂x||x| over all axes x if
// they do by eight units; for a component with a transform these are the axes of its own space. Besides, the sum of n
// fields is off by (n + 16)u of its terms, each of which takes some 16 operations, and relative errors of squared
// distances, 4u each, are amplified by hardness. A hit whose place is off by at most eight units of the ray's own
// coordinates is right. Another one before the true one is right if F is within the sum of these there; a later one, or
// a miss, if F has not left the ray's side by more from the true crossing on. (A crossing within the rounding and
// another object behind it: then the hit on that is right too.)
#pragma once

#include "renderer/rays/ray.h"
#include "renderer/reference/reference_tracer.h"
#include "renderer/scene/database.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace isl::reference {

enum class Verdict : std::uint8_t { agrees, missed, invented, misplaced, undecided };

/// Judges the first hits of one blob that is alone in the world and not transformed.
class RoundingRule {
 public:
  /// The database must outlive this.
  explicit RoundingRule(const scene::Database& database);

  struct Judged {
    Verdict verdict;  ///< `undecided`: the reference itself does not know
    bool is_hit;      ///< the reference has a surface on the ray
  };
  /// `found` is the solver's t, or nothing for a miss.
  [[nodiscard]] Judged judge(const render::Ray& ray, const std::optional<double>& found) const;
  /// |F| where a hit was found, over what the rule allows.
  [[nodiscard]] long double excess(const render::Ray& ray, double found) const;

 private:
  [[nodiscard]] Line field_ray(const render::Ray& ray) const {
    return {interval_of(ray.origin), interval_of(ray.direction)};
  }
  /// True if a first crossing at `found`, or none, is as right as the true one (null: there is none), which is known to
  /// its slack.
  [[nodiscard]] bool agree(const FieldOnRay& field, const render::Ray& ray, const Crossing* crossing,
                           const std::optional<double>& found, bool is_inside) const;
  /// The error of F at t that the rule allows.
  [[nodiscard]] long double band(const FieldOnRay& field, const render::Ray& ray, long double t) const;

  ReferenceField field_;
  std::vector<const scene::Transform*> transforms_;  ///< of each component; null if it has none
  std::vector<scene::Vec3> sizes_;  ///< the greatest coordinates that each component's surface is computed from
};

}  // namespace isl::reference
