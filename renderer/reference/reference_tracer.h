// Every root of F along a ray, and rays against the blobs of a database. It is the judge of solvers and tracer: certain
// rather than fast, and sharing no code with them.
//
// Cases that extended precision cannot decide (a surface touched to 1e-18) are reported as a touch, never guessed.
#pragma once

#include "renderer/reference/root_search.h"

#include <optional>
#include <vector>

namespace isl::ISL_REFERENCE {

struct RootOptions {
  Real t_max = kInfiniteReal;
  /// The origin is on the surface: the level set through it is searched, and its known root at t = 0 is left out.
  bool starts_on_root = false;
  Real start_band = 0;      ///< how far rounding may have moved F at such an origin
  int coming_from = 0;      ///< the sign of F before the origin, if it is known: it tells a crossing there from a touch
  bool first_only = false;  ///< stop after the first crossing
};

[[nodiscard]] RayRoots roots_along(const ReferenceField& field, const Line& ray, const RootOptions& options);

/// Encloses the largest F on [t0, t1] to about 1e-15 of the threshold (only from one side if many maxima compete).
[[nodiscard]] Interval largest_value(const FieldOnRay& field, Real t0, Real t1);

/// The blobs of a database, placed. Objects other than blobs are left out.
class ReferenceScene {
 public:
  explicit ReferenceScene(const scene::Database& database);

  struct Placed {
    ReferenceField field;
    scene::Transform world_from_object;
    bool no_shadow;
  };
  [[nodiscard]] const std::vector<Placed>& placed() const { return placed_; }

  /// A world-space ray in the space of one placed blob; t keeps its meaning.
  [[nodiscard]] static Line field_ray(const Placed& placed, const scene::Vec3& origin, const scene::Vec3& direction);

  struct Hit {
    Crossing crossing;
    std::size_t placed;  ///< index of the blob
  };
  /// The nearest surface with 0 < t < options.t_max. `starts_on_root` applies to every blob, so use it with one blob
  /// only.
  [[nodiscard]] std::optional<Hit> first_hit(const scene::Vec3& origin, const scene::Vec3& direction,
                                             RootOptions options = {}) const;

 private:
  void place(const scene::Database& database, const std::vector<scene::Object>& objects,
             const scene::Transform& world_from_parent);

  std::vector<Placed> placed_;
};

}  // namespace isl::ISL_REFERENCE
