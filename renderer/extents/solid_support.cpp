#include "renderer/extents/solid_support.h"

#include "base/check.h"
#include "renderer/solids/quadric_reach.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace isl::render {
namespace {

using scene::Database;
using scene::Solid;
using scene::SolidKind;
using scene::Vec3;

constexpr double kFar = std::numeric_limits<double>::infinity();

/// The part of `direction` across the unit `axis`: how far a disc of radius one across the axis reaches.
double across(const Vec3& direction, const Vec3& axis) { return (direction - axis * direction.dot(axis)).length(); }

/// Of discs of these radii about a and b, and of all between.
double capped(const Vec3& a, double radius_a, const Vec3& b, double radius_b, const Vec3& direction) {
  const double reach = across(direction, (b - a).normalized());
  return std::max(direction.dot(a) + radius_a * reach, direction.dot(b) + radius_b * reach);
}

/// Of the half-space p·normal ≤ distance.
double half_space(const Vec3& normal, double distance, const Vec3& direction) {
  // What rotations leave of parallelism after rounding.
  constexpr double kParallel = 1e-12;
  const double along = direction.dot(normal);
  const bool is_along = along > 0 && across(direction, normal) <= kParallel * along;
  return is_along ? along * distance : kFar;
}

double box(const Vec3& low, const Vec3& high, const Vec3& direction) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += std::max(direction[i] * low[i], direction[i] * high[i]);
  return sum;
}

/// The norm dual to ‖(x, y)‖ₚ with p = 2/exponent. Below p = 1 the unit ball is not convex; its hull is that of p = 1.
double dual_norm(double x, double y, double exponent) {
  x = std::abs(x);
  y = std::abs(y);
  const double p = 2 / exponent, largest = std::max(x, y);
  if (p <= 1 || largest == 0) return largest;
  const double dual = p / (p - 1);
  return largest * std::pow(std::pow(x / largest, dual) + std::pow(y / largest, dual), 1 / dual);
}

double farthest(std::span<const Vec3> points, const Vec3& direction) {
  double result = -kFar;
  for (const Vec3& point : points) result = std::max(result, direction.dot(point));
  return result;
}

}  // namespace

double support(const Database& database, const Solid& solid, const Vec3& direction) {
  switch (solid.kind) {
    case SolidKind::sphere: return direction.dot(solid.a) + solid.radius_a * direction.length();
    case SolidKind::cylinder: return capped(solid.a, solid.radius_a, solid.b, solid.radius_a, direction);
    case SolidKind::cone: return capped(solid.a, solid.radius_a, solid.b, solid.radius_b, direction);
    case SolidKind::plane: return half_space(solid.a, solid.radius_a, direction);
    case SolidKind::box: return box(solid.a, solid.b, direction);
    case SolidKind::torus:
      return solid.radius_a * std::hypot(direction.x, direction.z) + solid.radius_b * direction.length();
    case SolidKind::disc: return direction.dot(solid.a) + solid.radius_a * across(direction, solid.b);
    case SolidKind::quadric: return ellipsoid_reach(database.polynomials[solid.detail].coefficients, direction);
    case SolidKind::cubic:
    case SolidKind::quartic:
    case SolidKind::poly: return kFar;
    case SolidKind::superellipsoid:
      return dual_norm(dual_norm(direction.x, direction.y, solid.radius_a), direction.z, solid.radius_b);
    case SolidKind::triangle:
    case SolidKind::smooth_triangle: return farthest(database.triangles[solid.detail].corners, direction);
    case SolidKind::polygon: return farthest(database.polygons[solid.detail].points, direction);
  }
  ISL_CHECK(false, "solid kind {}", static_cast<int>(solid.kind));
}

Box box_of(const Database& database, const Solid& solid, const scene::Transform& world_from_solid) {
  const scene::Matrix& m = world_from_solid.matrix;
  Box result;
  for (int i = 0; i < 3; ++i) {
    // The coordinate i of a mapped point p is this · p, plus the offset.
    const Vec3 direction(m[0][i], m[1][i], m[2][i]);
    result.max[i] = support(database, solid, direction) + m[3][i];
    result.min[i] = -support(database, solid, -direction) + m[3][i];
  }
  return result;
}

}  // namespace isl::render
