// Turns pixels into rays by POV-Ray's convention: pixel (x, y) is the square from x to x + 1 and y to y + 1, y down
// from the top edge, so its centre is at x + ½, y + ½; image coordinates are u = x/width − ½ to the right and v = ½ −
// y/height up.
#pragma once

#include "renderer/film/projections.h"
#include "renderer/rays/ray.h"
#include "renderer/scene/database.h"

#include <memory>
#include <utility>

namespace isl::render {

/// The camera of a picture of some size. The picture's shape does not change the view; the camera's right and up do.
class CameraRays {
 public:
  /// `functions` are those of a `user_defined` camera.
  CameraRays(const scene::Camera& camera, int width, int height,
             std::shared_ptr<const CameraFunctions> functions = nullptr)
      : projection_(camera, std::move(functions)),
        per_column_(1.0 / width),
        per_row_(1.0 / height),
        focus_over_direction_(camera.blur ? camera.blur->focal_distance / camera.direction.length() : 0) {}

  /// True once a ray took more steps than the run allows: the rays of such a picture are not to be used.
  [[nodiscard]] bool is_spent() const { return projection_.is_spent(); }

  /// The ray through the raster position (x, y), in pixels from the picture's top left corner. Its direction is zero
  /// where the camera shows nothing. `angles` serve all rays of a batch.
  [[nodiscard]] Ray through(double x, double y, RecurringAngles& angles) const {
    Ray ray;
    set_through(x, y, angles, ray);
    return ray;
  }
  /// The same for the origin and direction of a ray.
  void set_through(double x, double y, RecurringAngles& angles, Ray& ray) const {
    const auto [u, v] = picture_point(x, y);
    if (camera().kind == scene::CameraKind::perspective) {
      ray.origin = camera().location;
      ray.direction = (camera().direction + camera().right * u + camera().up * v).normalized();
    } else {
      const ViewRay view = projection_.ray({u, v}, angles);
      ray.origin = view.origin;
      ray.direction = view.direction;
    }
  }

  /// The same for the ray to the same point in focus from another point of the lens (film/lens.h). Precondition: the
  /// camera has focal blur. Perspective cameras are in focus at a plane, others at a distance.
  void set_through(double x, double y, const Vec3& on_lens, RecurringAngles& angles, Ray& ray) const {
    Vec3 to_focus;
    if (camera().kind == scene::CameraKind::perspective) {
      const auto [u, v] = picture_point(x, y);
      ray.origin = camera().location;
      to_focus = (camera().direction + camera().right * u + camera().up * v) * focus_over_direction_;
    } else {
      set_through(x, y, angles, ray);
      if (ray.direction == Vec3(0)) return;
      to_focus = ray.direction * camera().blur->focal_distance;
    }
    ray.origin += on_lens;
    ray.direction = (to_focus - on_lens).normalized();
  }

  /// The place at which the camera's `normal` bends that ray.
  [[nodiscard]] PicturePoint bent_at(double x, double y) const { return projection_.bent_at(picture_point(x, y)); }

 private:
  [[nodiscard]] const scene::Camera& camera() const { return projection_.camera(); }
  [[nodiscard]] PicturePoint picture_point(double x, double y) const {
    return {x * per_column_ - 0.5, 0.5 - y * per_row_};
  }

  Projection projection_;
  double per_column_, per_row_;
  double focus_over_direction_;  ///< the distance in focus over the length of the camera's `direction`
};

/// The angle in radians that a pixel in the middle of the picture subtends, on the smaller of its two sides
/// (TracerOptions::pixel_angle). The rays of an orthographic camera have no apex: for them it is the angle at which the
/// picture is seen from a thousand times its width, so that tolerances in pixels are rather too fine than too coarse.
/// The same holds for the parallel rays of a `user_defined` camera, whose `functions` are needed.
[[nodiscard]] double pixel_angle(const scene::Camera& camera, int width, int height,
                                 std::shared_ptr<const CameraFunctions> functions = nullptr);

}  // namespace isl::render
