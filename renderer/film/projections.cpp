#include "renderer/film/projections.h"

#include <cmath>
#include <numbers>
#include <utility>

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
Vec3 turned(const Vec3& vector, const Vec3& axis, const SineCosine& angle) {
  return vector * angle.cosine + axis.cross(vector) * angle.sine + axis * (axis.dot(vector) * (1 - angle.cosine));
}

/// The angle of a place of a disc to the horizontal, from -90° on over 90° on the right to 270°.
double bearing(const PicturePoint& place) {
  const double length = std::hypot(place.u, place.v);
  if (length == 0) return 0;
  const double angle = std::asin(place.v / length);
  return place.u < 0 ? kPi - angle : angle;
}

}  // namespace

Projection::Projection(const Camera& camera, std::shared_ptr<const CameraFunctions> functions)
    : camera_(camera),
      functions_(std::move(functions)),
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

Vec3 Projection::ultra_wide_angle(const PicturePoint& at, RecurringAngles& angles) const {
  const SineCosine across = angles(at.u * camera_.angle), along = angles(at.v * angle_along_);
  return right_ * across.sine + up_ * along.sine + ahead_ * (across.cosine * along.cosine);
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
Vec3 Projection::panoramic(const PicturePoint& at, RecurringAngles& angles) const {
  const SineCosine across = angles((0.5 - at.u) * kPi), along = angles(at.v * kPi);
  return camera_.right * across.cosine + camera_.up * (along.sine / along.cosine) + camera_.direction * across.sine;
}

/// A cylinder about `up` (types 1 and 3) or `right` (2 and 4). Rays start at its axis' middle, or all along it.
ViewRay Projection::cylinder(const PicturePoint& at, RecurringAngles& angles) const {
  if (camera_.cylinder_type % 2 == 1) return from_axis(up_ * (at.v * height_), right_, angles(at.u * camera_.angle));
  return from_axis(right_ * (at.u * width_), up_, angles(at.v * camera_.angle));
}

/// The ray of a cylinder at a height along its axis, turned from `ahead` towards `aside`.
ViewRay Projection::from_axis(const Vec3& height, const Vec3& aside, const SineCosine& angle) const {
  const Vec3 around = aside * angle.sine + ahead_ * angle.cosine;
  if (camera_.cylinder_type <= 2) return {camera_.location, around + height};
  return {camera_.location + height, around};
}

/// Longitudes and latitudes.
Vec3 Projection::spherical(const PicturePoint& at, RecurringAngles& angles) const {
  const Vec3 raised = turned(ahead_, right_, angles(-at.v * camera_.vertical_angle));
  return turned(raised, up_, angles(at.u * camera_.angle));
}

ViewRay Projection::unnormalized(const PicturePoint& at, RecurringAngles& angles) const {
  const Vec3 across = camera_.right * at.u + camera_.up * at.v;
  switch (camera_.kind) {
    case CameraKind::perspective: return {camera_.location, camera_.direction + across};
    case CameraKind::orthographic: return {camera_.location + across, camera_.direction};
    case CameraKind::fisheye: return {camera_.location, fisheye(at)};
    case CameraKind::ultra_wide_angle: return {camera_.location, ultra_wide_angle(at, angles)};
    case CameraKind::omnimax: return {camera_.location, omnimax(at)};
    case CameraKind::panoramic: return {camera_.location, panoramic(at, angles)};
    case CameraKind::cylinder: return cylinder(at, angles);
    case CameraKind::spherical: return {camera_.location, spherical(at, angles)};
    case CameraKind::user_defined: return functions_ ? functions_->ray(at) : ViewRay{Vec3(0), Vec3(0)};
  }
  return {};
}

/// Everything is inlined, so that vectors stay in registers. A vector that is returned in memory is read in other
/// pieces than it was written in, and the processor waits for that as long as for its length.
[[gnu::flatten]] ViewRay Projection::ray(const PicturePoint& at, RecurringAngles& angles) const {
  ViewRay ray = unnormalized(at, angles);
  ray.direction.normalize();
  return ray;
}

PicturePoint Projection::bent_at(const PicturePoint& at) const {
  switch (camera_.kind) {
    case CameraKind::perspective:
    case CameraKind::orthographic:
    case CameraKind::user_defined: return at;
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
