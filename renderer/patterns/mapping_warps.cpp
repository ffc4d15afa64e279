#include "renderer/patterns/mapping_warps.h"

#include "base/check.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isl::render {
namespace {

using scene::MappingWarp;
using scene::Vec3;

constexpr double kTurn = 2 * std::numbers::pi;

/// Maps z to the orientation, as measured in POV-Ray at many orientations: the map is linear in the orientation's
/// terms, and a rotation only for the axes.
Vec3 oriented(const Vec3& p, const Vec3& orientation) {
  const Vec3 n = orientation.normalized();
  return {(n.y + n.z) * p.x + n.x * p.z, (n.x + n.z) * p.y - n.y * p.z, n.y * p.y - n.x * p.x + n.z * p.z};
}

/// The angle from x towards z as a share of the full circle, in [0, 1].
double turn_about_y(const Vec3& p, double radius) {
  if (p.z == 0) return p.x > 0 ? 0 : 0.5;
  const double angle = std::acos(p.x / radius);
  return (p.z < 0 ? kTurn - angle : angle) / kTurn;
}

double stretched(double value, double distance, double exponent) {
  return exponent == 0 ? value : value * std::pow(distance, exponent);
}

Vec3 around_cylinder(const MappingWarp& warp, const Vec3& p) {
  const double radius = std::sqrt(p.x * p.x + p.z * p.z);
  if (radius == 0) return Vec3(0);
  return {stretched(turn_about_y(p, radius), radius, warp.distance_exponent), p.y, radius};
}

Vec3 around_sphere(const MappingWarp& warp, const Vec3& p) {
  const double distance = std::sqrt(p.dot(p));
  if (distance == 0) return Vec3(0);
  const double radius = std::sqrt(p.x * p.x + p.z * p.z);
  const double turn = radius == 0 ? 0 : turn_about_y(p, radius);
  const double height = 0.5 + std::asin(p.y / distance) / std::numbers::pi;
  return {stretched(turn, distance, warp.distance_exponent), stretched(height, distance, warp.distance_exponent),
          distance};
}

Vec3 around_torus(const MappingWarp& warp, const Vec3& p) {
  const double radius = std::sqrt(p.x * p.x + p.z * p.z);
  if (radius == 0) return Vec3(0);
  const double outward = radius - warp.major_radius;
  const double distance = std::sqrt(outward * outward + p.y * p.y);
  const double angle = std::acos(outward / distance);
  const double around_tube = 0.5 + (p.y < 0 ? -angle : angle) / kTurn;
  return {stretched(turn_about_y(p, radius), distance, warp.distance_exponent),
          stretched(around_tube, distance, warp.distance_exponent), distance};
}

/// The cube unfolded into six squares: four in a row along x, one above and one below the second.
Vec3 around_cube(const Vec3& p) {
  const Vec3 size(std::abs(p.x), std::abs(p.y), std::abs(p.z));
  const double distance = std::max({size.x, size.y, size.z});
  const Vec3 q = p / distance;
  constexpr double kColumn = 1.0 / 8, kRow = 1.0 / 6;  // half a square
  if (size.x >= size.y && size.x >= size.z) {
    const double middle = p.x >= 0 ? 5 * kColumn : kColumn;
    return {p.x >= 0 ? middle - kColumn * q.z : middle + kColumn * q.z, 3 * kRow + kRow * q.y, distance};
  }
  if (size.y >= size.z) {
    const double middle = p.y >= 0 ? 5 * kRow : kRow;
    return {3 * kColumn + kColumn * q.x, p.y >= 0 ? middle - kRow * q.z : middle + kRow * q.z, distance};
  }
  const double middle = p.z >= 0 ? 3 * kColumn : 7 * kColumn;
  return {p.z >= 0 ? middle + kColumn * q.x : middle - kColumn * q.x, 3 * kRow + kRow * q.y, distance};
}

}  // namespace

Vec3 mapped(const MappingWarp& warp, const Vec3& p) noexcept {
  switch (warp.shape) {
    case MappingWarp::Shape::cylinder: return oriented(around_cylinder(warp, p), warp.orientation);
    case MappingWarp::Shape::sphere: return oriented(around_sphere(warp, p), warp.orientation);
    case MappingWarp::Shape::torus: return oriented(around_torus(warp, p), warp.orientation);
    case MappingWarp::Shape::plane: return oriented(Vec3(p.x, p.y, warp.distance), warp.orientation);
    case MappingWarp::Shape::cube: return around_cube(p);
  }
  ISL_CHECK(false, "warp {}", static_cast<int>(warp.shape));
}

}  // namespace isl::render
