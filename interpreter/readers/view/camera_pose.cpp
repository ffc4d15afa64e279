#include "interpreter/readers/view/camera_pose.h"

#include "interpreter/transforms.h"

#include <algorithm>
#include <cmath>

namespace isl::interpreter {

using scene::Camera;
using scene::Vec3;

namespace {

/// POV-Ray's own bound, on each coordinate: below it the view counts as parallel to the sky.
constexpr double kAlongSky = 1e-10;

bool is_along_sky(const Vec3& sideways) {
  return std::max({std::abs(sideways.x), std::abs(sideways.y), std::abs(sideways.z)}) < kAlongSky;
}

/// The unit vector to the picture's right edge. A view parallel to the sky has none; as in POV-Ray the camera's own
/// `right` is used, and here some perpendicular if that is parallel to the view too.
Vec3 sideways_of(const Camera& camera, const Vec3& forward, const Vec3& sky) {
  Vec3 sideways = sky.cross(forward);
  if (is_along_sky(sideways)) sideways = camera.right / camera.right.length();
  if (is_along_sky(sideways.cross(forward))) sideways = forward.cross(Vec3(forward.y, forward.z, -forward.x));
  return sideways / sideways.length();
}

}  // namespace

void set_horizontal_angle(Camera& camera, double degrees) {
  const double length = camera.right.length() / (2 * std::tan(radians_from_degrees(degrees) / 2));
  camera.direction *= length / camera.direction.length();
}

void look_at(Camera& camera, const Vec3& target, const Vec3& sky) {
  const double direction = camera.direction.length(), right = camera.right.length(), up = camera.up.length();
  // As in POV-Ray, a `right` in the plane of up and direction has no handedness and gets the mirrored one.
  const bool is_mirrored = !(camera.up.cross(camera.direction).dot(camera.right) > 0);
  const Vec3 ahead = target - camera.location;
  const Vec3 forward = ahead / ahead.length();
  const Vec3 sideways = sideways_of(camera, forward, sky);
  camera.direction = forward * direction;
  camera.up = forward.cross(sideways) * up;
  camera.right = sideways * (is_mirrored ? -right : right);
}

}  // namespace isl::interpreter
