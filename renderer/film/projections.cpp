#include "renderer/film/projections.h"

#include <cmath>
#include <numbers>

namespace isl::render {
namespace {

using scene::Camera;
using scene::CameraKind;

constexpr double kPi = std::numbers::pi;

/// The camera's vectors as axes, and their lengths.
struct Axes {
  explicit Axes(const Camera& camera)
      : right(camera.right.normalized()),
        up(camera.up.normalized()),
        ahead(camera.direction.normalized()),
        width(camera.right.length()),
        height(camera.up.length()) {}

  Vec3 right, up, ahead;
  double width, height;
};

/// The direction at an angle from `ahead`, towards (a, b) of the picture. `length` is that of (a, b).
Vec3 turned_aside(const Axes& axes, double angle, double a, double b, double length) {
  if (length == 0) return axes.ahead;
  const double sine = std::sin(angle) / length;
  return axes.right * (a * sine) + axes.up * (b * sine) + axes.ahead * std::cos(angle);
}

/// The angle grows with the distance from the picture's middle: half of the camera's angle at its edge.
Vec3 fisheye(const Camera& camera, const PicturePoint& at) {
  const Axes axes(camera);
  const double a = 2 * at.u * axes.width, b = 2 * at.v * axes.height, length = std::hypot(a, b);
  if (length > 1) return Vec3(0);
  return turned_aside(axes, length * camera.angle / 2, a, b, length);
}

Vec3 ultra_wide_angle(const Camera& camera, const PicturePoint& at) {
  const Axes axes(camera);
  const double across = at.u * camera.angle, along = at.v * camera.angle * axes.height / axes.width;
  return axes.right * std::sin(across) + axes.up * std::sin(along) + axes.ahead * (std::cos(across) * std::cos(along));
}

/// A fisheye of 180° for the dome of an Omnimax theatre, whose screen ends 45° below the horizon. The constants are
/// POV-Ray's.
Vec3 omnimax(const Camera& camera, const PicturePoint& at) {
  constexpr double kShape = 1.283458;
  const Axes axes(camera);
  const double shape = axes.width / axes.height;
  double a = 2 * at.u, b = 2 * at.v;
  if (shape < 1) {
    b /= shape;
  } else if (shape < kShape) {
    b = (b - 1) / shape + 1;
  } else {
    a *= shape / kShape;
    b = (b - 1) / kShape + 1;
  }
  const double length = std::hypot(a, b);
  if (length > 1) return Vec3(0);
  const double squared = length * length;
  const double angle = length * (1.411269 + squared * (-0.09439 + squared * 0.25674));
  const double rise = length > 0 ? std::sin(angle) * b / length : 0;
  if (rise < -std::cos(angle)) return Vec3(0);
  return turned_aside(axes, angle, a, b, length);
}

/// A cylinder about `up`, on whose wall heights are tangents. The vectors carry their lengths.
Vec3 panoramic(const Camera& camera, const PicturePoint& at) {
  const double across = (0.5 - at.u) * kPi;
  return camera.right * std::cos(across) + camera.up * std::tan(at.v * kPi) + camera.direction * std::sin(across);
}

/// A cylinder about `up` (types 1 and 3) or `right` (2 and 4). Rays start at its axis' middle, or all along it.
ViewRay cylinder(const Camera& camera, const PicturePoint& at) {
  const Axes axes(camera);
  const bool is_upright = camera.cylinder_type % 2 == 1;
  const double angle = (is_upright ? at.u : at.v) * camera.angle;
  const Vec3 around = (is_upright ? axes.right : axes.up) * std::sin(angle) + axes.ahead * std::cos(angle);
  const Vec3 along = is_upright ? axes.up * (at.v * axes.height) : axes.right * (at.u * axes.width);
  if (camera.cylinder_type <= 2) return {camera.location, around + along};
  return {camera.location + along, around};
}

/// Turns a vector that is perpendicular to the unit axis.
Vec3 turned(const Vec3& vector, const Vec3& axis, double angle) {
  return vector * std::cos(angle) + axis.cross(vector) * std::sin(angle) +
         axis * (axis.dot(vector) * (1 - std::cos(angle)));
}

/// Longitudes and latitudes.
Vec3 spherical(const Camera& camera, const PicturePoint& at) {
  const Axes axes(camera);
  const Vec3 raised = turned(axes.ahead, axes.right, -at.v * camera.vertical_angle);
  return turned(raised, axes.up, at.u * camera.angle);
}

ViewRay unnormalized(const Camera& camera, const PicturePoint& at) {
  const Vec3 across = camera.right * at.u + camera.up * at.v;
  switch (camera.kind) {
    case CameraKind::perspective: return {camera.location, camera.direction + across};
    case CameraKind::orthographic: return {camera.location + across, camera.direction};
    case CameraKind::fisheye: return {camera.location, fisheye(camera, at)};
    case CameraKind::ultra_wide_angle: return {camera.location, ultra_wide_angle(camera, at)};
    case CameraKind::omnimax: return {camera.location, omnimax(camera, at)};
    case CameraKind::panoramic: return {camera.location, panoramic(camera, at)};
    case CameraKind::cylinder: return cylinder(camera, at);
    case CameraKind::spherical: return {camera.location, spherical(camera, at)};
  }
  return {};
}

}  // namespace

ViewRay view_ray(const Camera& camera, const PicturePoint& at) {
  ViewRay ray = unnormalized(camera, at);
  ray.direction.normalize();
  return ray;
}

}  // namespace isl::render
