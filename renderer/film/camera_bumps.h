// The `normal` of a camera: bumps that bend its rays, as glass of uneven thickness before the lens would. The direction
// of a ray is bent like the normal of a surface, at a place that
// depends on the projection (film/projections.h).
#pragma once

#include "renderer/film/view_ray.h"
#include "renderer/patterns/patterns.h"
#include "renderer/queries/insides.h"

namespace isl::render {

/// Serves one database, which must outlive it; shared by all threads.
class CameraBumps {
 public:
  /// Precondition: the database has a camera with a `normal`. `images` may be null if it has none of them.
  CameraBumps(const scene::Database& database, const RunLimits& run, const ImageTable* images)
      : bumps_(database.normals[index(database.camera->normal)]),
        run_(run),
        insides_(database, run),
        patterns_(database, &insides_, database.settings.number_of_waves, images),
        noise_generator_(values::noise_generator_of(database.settings.noise_generator)) {}
  CameraBumps(const CameraBumps&) = delete;
  CameraBumps& operator=(const CameraBumps&) = delete;

  /// Bends the unit direction of a ray at a place. False if the steps of the run did not suffice,
  /// or the run is stopped.
  [[nodiscard]] bool bend(const PicturePoint& at, Vec3& direction) const {
    values::Environment environment(noise_generator_, run_, &patterns_);
    direction = patterns_.bent(bumps_, Vec3(at.u, at.v, 0), direction, environment);
    return !environment.is_spent();
  }

 private:
  const scene::Normal& bumps_;
  RunLimits run_;
  Insides insides_;
  Patterns patterns_;
  values::NoiseGenerator noise_generator_;
};

}  // namespace isl::render
