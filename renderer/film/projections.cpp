#include "renderer/film/projections.h"

#include <cmath>
#include <numbers>

namespace isl::render {
namespace {

using scene::Camera;
using scene::CameraKind;

constexpr double kPi = std::numbers::pi;

/// The angle from the axis of rays at a distance from the middle of the dome. The constants are POV-Ray's.
double dome_angle(double length) {
  const double squared = length * length;
  return length * (1.411269 + squared * (-0.09439 + squared * 0.25674));
}

/// Turns a vector that is perpendicular to the unit axis.
Vec3 turned(const Vec3& vector, const Vec3& axis, double angle) {
  return vector * std::cos(angle) + axis.cross(vector) * std::sin(angle) +
         axis * (axis.dot(vector) * (1 - std::cos(angle)));
}

/// The angle of a place of a disc to the horizontal, from -90° on over 90° on the right to 270°.
double bearing(const PicturePoint& place) {
  const double length = std::hypot(place.u, place.v);
  if (length == 0) return 0;
  const double angle = std::asin(place.v / length);
  return place.u < 0 ? kPi - angle : angle;
}

}  // namespace

Projection::Projection(const Camera& camera)
    : camera_(camera),
      right_(camera.right.normalized()),
      up_(camera.up.normalized()),
      ahead_(camera.direction.normalized()),
      width_(camera.right.length()),
      height_(camera.up.length()),
      angle_along_(camera.angle * height_ / width_) {}

/// The direction at an angle from `ahead`, towards (a, b) of the picture. `length` is that of (a, b).
Vec3 Projection::turned_aside(double angle, double a, double b, double length) const {
  if (length == 0) return ahead_;
  const double sine = std::sin(angle) / length;
  return right_ * (a * sine) + up_ * (b * sine) + ahead_ * std::cos(angle);
}

/// The place in the disc that a fisheye shows.
PicturePoint Projection::in_disc(const PicturePoint& at) const { return {2 * at.u * width_, 2 * at.v * height_}; }

/// The angle grows with the distance from the picture's middle: half of the camera's angle at its edge.
Vec3 Projection::fisheye(const PicturePoint& at) const {
  const auto [a, b] = in_disc(at);
  const double length = std::sqrt(a * a + b * b);
  if (length > 1) return Vec3(0);
  return turned_aside(length * camera_.angle / 2, a, b, length);
}

Vec3 Projection::ultra_wide_angle(const PicturePoint& at) const {
  const double across = at.u * camera_.angle, along = at.v * angle_along_;
  return right_ * std::sin(across) + up_ * std::sin(along) + ahead_ * (std::cos(across) * std::cos(along));
}

/// The place on the dome of an Omnimax theatre, seen from above. The constants are POV-Ray's.
PicturePoint Projection::on_dome(const PicturePoint& at) const {
  constexpr double kShape = 1.283458;
  const double shape = width_ / height_, a = 2 * at.u, b = 2 * at.v;
  if (shape < 1) return {a, b / shape};
  if (shape < kShape) return {a, (b - 1) / shape + 1};
  return {a * shape / kShape, (b - 1) / kShape + 1};
}

/// A fisheye of 180° for such a dome, whose screen ends 45° below the horizon.
Vec3 Projection::omnimax(const PicturePoint& at) const {
  const auto [a, b] = on_dome(at);
  const double length = std::sqrt(a * a + b * b);
  if (length > 1) return Vec3(0);
  const double angle = dome_angle(length);
  const double rise = length > 0 ? std::sin(angle) * b / length : 0;
  if (rise < -std::cos(angle)) return Vec3(0);
  return turned_aside(angle, a, b, length);
}

/// A cylinder about `up`, on whose wall heights are tangents. The vectors carry their lengths.
Vec3 Projection::panoramic(const PicturePoint& at) const {
  const double across = (0.5 - at.u) * kPi;
  return camera_.right * std::cos(across) + camera_.up * std::tan(at.v * kPi) + camera_.direction * std::sin(across);
}

/// A cylinder about `up` (types 1 and 3) or `right` (2 and 4). Rays start at its axis' middle, or all along it.
ViewRay Projection::cylinder(const PicturePoint& at) const {
  const bool is_upright = camera_.cylinder_type % 2 == 1;
  const double angle = (is_upright ? at.u : at.v) * camera_.angle;
  const Vec3 around = (is_upright ? right_ : up_) * std::sin(angle) + ahead_ * std::cos(angle);
  const Vec3 along = is_upright ? up_ * (at.v * height_) : right_ * (at.u * width_);
  if (camera_.cylinder_type <= 2) return {camera_.location, around + along};
  return {camera_.location + along, around};
}

/// Longitudes and latitudes.
Vec3 Projection::spherical(const PicturePoint& at) const {
  const Vec3 raised = turned(ahead_, right_, -at.v * camera_.vertical_angle);
  return turned(raised, up_, at.u * camera_.angle);
}

ViewRay Projection::unnormalized(const PicturePoint& at) const {
  const Vec3 across = camera_.right * at.u + camera_.up * at.v;
  switch (camera_.kind) {
    case CameraKind::perspective: return {camera_.location, camera_.direction + across};
    case CameraKind::orthographic: return {camera_.location + across, camera_.direction};
    case CameraKind::fisheye: return {camera_.location, fisheye(at)};
    case CameraKind::ultra_wide_angle: return {camera_.location, ultra_wide_angle(at)};
    case CameraKind::omnimax: return {camera_.location, omnimax(at)};
    case CameraKind::panoramic: return {camera_.location, panoramic(at)};
    case CameraKind::cylinder: return cylinder(at);
    case CameraKind::spherical: return {camera_.location, spherical(at)};
  }
  return {};
}

ViewRay Projection::ray(const PicturePoint& at) const {
  ViewRay ray = unnormalized(at);
  ray.direction.normalize();
  return ray;
}

PicturePoint Projection::bent_at(const PicturePoint& at) const {
  switch (camera_.kind) {
    case CameraKind::perspective:
    case CameraKind::orthographic: return at;
    case CameraKind::fisheye: {
      const PicturePoint place = in_disc(at);
      return {bearing(place), std::hypot(place.u, place.v) * camera_.angle / 2};
    }
    case CameraKind::ultra_wide_angle: return {at.u * camera_.angle, at.v * angle_along_};
    case CameraKind::omnimax: {
      const PicturePoint place = on_dome(at);
      return {bearing(place), dome_angle(std::hypot(place.u, place.v))};
    }
    case CameraKind::panoramic: return {(0.5 - at.u) * kPi, at.v * kPi};
    case CameraKind::cylinder:
      if (camera_.cylinder_type % 2 == 1) return {at.u * camera_.angle, at.v * height_};
      return {at.u * width_, at.v * camera_.angle};
    case CameraKind::spherical: return {at.u * camera_.angle, at.v * camera_.vertical_angle};
  }
  return at;
}

}  // namespace isl::render
