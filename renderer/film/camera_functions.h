// The rays of a `user_defined` camera: the points where they start and their directions are functions of the image
// point.
#pragma once

#include "renderer/film/view_ray.h"
#include "renderer/patterns/patterns.h"
#include "renderer/queries/insides.h"
#include "renderer/scene/database.h"

#include <atomic>
#include <memory>

namespace isl::render {

/// Serves one database, which must outlive it; shared by all threads.
class CameraFunctions {
 public:
  /// Null unless the database's camera is `user_defined`. `run` limits the steps of each ray. `images` may be null if
  /// no function has one.
  [[nodiscard]] static std::shared_ptr<const CameraFunctions> of(const scene::Database& database,
                                                                 const RunLimits& run = {},
                                                                 const ImageTable* images = nullptr);

  CameraFunctions(const scene::Database& database, const RunLimits& run, const ImageTable* images)
      : database_(database),
        run_(run),
        insides_(database, run),
        patterns_(database, &insides_, database.settings.number_of_waves, images),
        noise_generator_(values::noise_generator_of(database.settings.noise_generator)) {}
  CameraFunctions(const CameraFunctions&) = delete;
  CameraFunctions& operator=(const CameraFunctions&) = delete;

  /// The ray through a point of the picture, of any length. As in POV-Ray, it shows nothing if a coordinate is not
  /// finite, or no coordinate of its direction is above 1e-10.
  [[nodiscard]] ViewRay ray(const PicturePoint& at) const;
  /// True once a ray took more steps than the run allows, or the run was stopped.
  [[nodiscard]] bool is_spent() const { return is_spent_.load(std::memory_order_relaxed); }

 private:
  [[nodiscard]] Vec3 value(const scene::VectorFunctions& functions, const Vec3& otherwise, const PicturePoint& at,
                           values::Environment& environment) const;

  const scene::Database& database_;
  RunLimits run_;
  Insides insides_;
  Patterns patterns_;
  values::NoiseGenerator noise_generator_;
  mutable std::atomic<bool> is_spent_ = false;
};

/// The place of the database's camera; of a `user_defined` one, where the ray in the middle of the picture starts.
[[nodiscard]] Vec3 eye_of(const scene::Database& database);

}  // namespace isl::render
