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

/// The place in the disc that a fisheye shows.
PicturePoint in_disc(const Axes& axes, const PicturePoint& at) {
  return {2 * at.u * axes.width, 2 * at.v * axes.height};
}

/// The angle grows with the distance from the picture's middle: half of the camera's angle at its edge.
Vec3 fisheye(const Camera& camera, const PicturePoint& at) {
  const Axes axes(camera);
  const auto [a, b] = in_disc(axes, at);
  const double length = std::hypot(a, b);
  if (length > 1) return Vec3(0);
  return turned_aside(axes, length * camera.angle / 2, a, b, length);
}

Vec3 ultra_wide_angle(const Camera& camera, const PicturePoint& at) {
  const Axes axes(camera);
  const double across = at.u * camera.angle, along = at.v * camera.angle * axes.height / axes.width;
  return axes.right * std::sin(across) + axes.up * std::sin(along) + axes.ahead * (std::cos(across) * std::cos(along));
}

/// The place on the dome of an Omnimax theatre, seen from above. The constants are POV-Ray's.
PicturePoint on_dome(const Axes& axes, const PicturePoint& at) {
  constexpr double kShape = 1.283458;
  const double shape = axes.width / axes.height, a = 2 * at.u, b = 2 * at.v;
  if (shape < 1) return {a, b / shape};
  if (shape < kShape) return {a, (b - 1) / shape + 1};
  return {a * shape / kShape, (b - 1) / kShape + 1};
}

/// The angle from the axis of rays at a distance from the middle of the dome. The constants are POV-Ray's.
double dome_angle(double length) {
  const double squared = length * length;
  return length * (1.411269 + squared * (-0.09439 + squared * 0.25674));
}

/// A fisheye of 180° for such a dome, whose screen ends 45° below the horizon.
Vec3 omnimax(const Camera& camera, const PicturePoint& at) {
  const Axes axes(camera);
  const auto [a, b] = on_dome(axes, at);
  const double length = std::hypot(a, b);
  if (length > 1) return Vec3(0);
  const double angle = dome_angle(length);
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

/// The angle of a place of a disc to the horizontal, from -90° on over 90° on the right to 270°.
double bearing(const PicturePoint& place) {
  const double length = std::hypot(place.u, place.v);
  if (length == 0) return 0;
  const double angle = std::asin(place.v / length);
  return place.u < 0 ? kPi - angle : angle;
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

PicturePoint bent_at(const Camera& camera, const PicturePoint& at) {
  const Axes axes(camera);
  switch (camera.kind) {
    case CameraKind::perspective:
    case CameraKind::orthographic: return at;
    case CameraKind::fisheye: {
      const PicturePoint place = in_disc(axes, at);
      return {bearing(place), std::hypot(place.u, place.v) * camera.angle / 2};
    }
    case CameraKind::ultra_wide_angle: return {at.u * camera.angle, at.v * camera.angle * axes.height / axes.width};
    case CameraKind::omnimax: {
      const PicturePoint place = on_dome(axes, at);
      return {bearing(place), dome_angle(std::hypot(place.u, place.v))};
    }
    case CameraKind::panoramic: return {(0.5 - at.u) * kPi, at.v * kPi};
    case CameraKind::cylinder:
      if (camera.cylinder_type % 2 == 1) return {at.u * camera.angle, at.v * axes.height};
      return {at.u * axes.width, at.v * camera.angle};
    case CameraKind::spherical: return {at.u * camera.angle, at.v * camera.vertical_angle};
  }
  return at;
}

}  // namespace isl::render
