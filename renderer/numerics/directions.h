// Directions for points of the unit square.
#pragma once

#include "renderer/numerics/sample_points.h"

#include <ImathVec.h>

#include <cmath>
#include <numbers>

namespace isl::render {

/// A direction of the hemisphere about a unit normal, with the density cos θ/π per steradian. The map keeps areas, so
/// evenly spread points become evenly spread directions (Malley's method).
[[nodiscard]] inline Imath::V3d cosine_direction(const UnitPoint& at, const Imath::V3d& normal) {
  using Vector = Imath::V3d;
  // Two axes across the normal (Duff and others, Building an Orthonormal Basis, Revisited, 2017).
  const double sign = std::copysign(1.0, normal.z);
  const double a = -1 / (sign + normal.z), b = normal.x * normal.y * a;
  const Vector across(1 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
  const Vector along(b, sign + normal.y * normal.y * a, -normal.y);
  const double radius = std::sqrt(at.u), angle = 2 * std::numbers::pi * at.v;
  const Vector direction =
      across * (radius * std::cos(angle)) + along * (radius * std::sin(angle)) + normal * std::sqrt(1 - at.u);
  return direction.normalized();
}

/// A direction of the whole sphere; equal areas of the square are equal solid angles. v goes from -y to +y.
[[nodiscard]] inline Imath::V3d sphere_direction(const UnitPoint& at) {
  const double height = 2 * at.v - 1, angle = 2 * std::numbers::pi * at.u;
  const double radius = std::sqrt(std::max(0.0, 1 - height * height));
  return {radius * std::cos(angle), height, radius * std::sin(angle)};
}

/// The point of the square that belongs to a direction.
[[nodiscard]] inline UnitPoint sphere_point(const Imath::V3d& direction) {
  const double turn = std::atan2(direction.z, direction.x) / (2 * std::numbers::pi);
  return {turn < 0 ? turn + 1 : turn, (direction.y + 1) / 2};
}

}  // namespace isl::render
