// The projections of cameras: the ray through a point of the picture.
#pragma once

#include "renderer/film/camera_functions.h"
#include "renderer/film/recurring_angles.h"
#include "renderer/film/view_ray.h"
#include "renderer/rays/ray.h"
#include "renderer/scene/camera.h"

namespace isl::render {

/// The projection of one camera. Formulas as in POV-Ray.
class Projection {
 public:
  /// `functions` are those of a `user_defined` camera, which shows nothing without them.
  explicit Projection(const scene::Camera& camera, std::shared_ptr<const CameraFunctions> functions = nullptr);

  [[nodiscard]] const scene::Camera& camera() const { return camera_; }
  /// CameraFunctions::is_spent.
  [[nodiscard]] bool is_spent() const { return functions_ && functions_->is_spent(); }
  /// The ray through a point of the picture. The direction has unit length.
  [[nodiscard]] ViewRay ray(const PicturePoint& at, RecurringAngles& angles) const;
  /// The place at which the camera's `normal` bends this ray, in the units in which POV-Ray measures it: shares of the
  /// picture, angles in radians, or lengths, as the kind of camera has them.
  [[nodiscard]] PicturePoint bent_at(const PicturePoint& at) const;

 private:
  [[nodiscard]] ViewRay unnormalized(const PicturePoint& at, RecurringAngles& angles) const;

  [[nodiscard]] Vec3 turned_aside(double angle, double a, double b, double length) const;
  [[nodiscard]] PicturePoint in_disc(const PicturePoint& at) const;
  [[nodiscard]] PicturePoint on_dome(const PicturePoint& at) const;
  [[nodiscard]] Vec3 fisheye(const PicturePoint& at) const;
  [[nodiscard]] Vec3 ultra_wide_angle(const PicturePoint& at, RecurringAngles& angles) const;
  [[nodiscard]] Vec3 omnimax(const PicturePoint& at) const;
  [[nodiscard]] Vec3 panoramic(const PicturePoint& at, RecurringAngles& angles) const;
  [[nodiscard]] ViewRay cylinder(const PicturePoint& at, RecurringAngles& angles) const;
  [[nodiscard]] ViewRay from_axis(const Vec3& height, const Vec3& aside, const SineCosine& angle) const;
  [[nodiscard]] Vec3 spherical(const PicturePoint& at, RecurringAngles& angles) const;

  scene::Camera camera_;
  std::shared_ptr<const CameraFunctions> functions_;
  Vec3 right_, up_, ahead_;  ///< the camera's vectors as axes
  double width_, height_;    ///< lengths of its right and up
  double angle_along_;       ///< the camera's angle, from side to side of the picture, for its height
};

}  // namespace isl::render
