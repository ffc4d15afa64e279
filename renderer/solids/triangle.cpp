// triangle, smooth_triangle: flat between three corners.
//
// With the corners A, B, C seen from the line's origin, the line passes an edge on the side that the sign of
// (B × A)·d tells (Plücker coordinates). Swapping the ends of an edge gives exactly the opposite number, so that of two
// triangles which share it a line that does not meet one meets the other: meshes have no cracks. A line within the
// plane meets nothing.
#include "renderer/solids/kinds.h"

#include <algorithm>
#include <cmath>

namespace isl::render {
namespace {

/// Across the corners, of any length; the side that POV-Ray calls outside.
Vec3 across(const scene::Triangle& triangle) {
  return (triangle.corners[0] - triangle.corners[1]).cross(triangle.corners[2] - triangle.corners[1]);
}

}  // namespace

Crossings triangle_crossings(const scene::Triangle& triangle, const Vec3& origin, const Vec3& direction,
                             std::uint8_t start_part) noexcept {
  Crossings result;
  if (start_part == kSide) return result;
  const Vec3 a = triangle.corners[0] - origin, b = triangle.corners[1] - origin, c = triangle.corners[2] - origin;
  const double u = c.cross(b).dot(direction), v = a.cross(c).dot(direction), w = b.cross(a).dot(direction);
  const bool is_met = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
  if (!is_met || (u == 0 && v == 0 && w == 0)) return result;
  const Vec3 normal = across(triangle);
  const double rise = normal.dot(direction);
  if (rise == 0) return result;
  // From the nearest corner, so that large triangles keep the digits of near ones.
  const double da = a.length2(), db = b.length2(), dc = c.length2();
  const Vec3& nearest = da <= db && da <= dc ? a : (db <= dc ? b : c);
  result.add(normal.dot(nearest) / rise, kSide);
  return result;
}

Vec3 triangle_normal(const scene::Triangle& triangle) noexcept { return across(triangle).normalized(); }

/// The corners' normals, weighted by the areas between the point and the opposite edges.
Vec3 smooth_normal(const scene::Triangle& triangle, const Vec3& point) noexcept {
  const Vec3 normal = across(triangle);
  const Vec3 a = triangle.corners[0] - point, b = triangle.corners[1] - point, c = triangle.corners[2] - point;
  const Vec3 sum = triangle.normals[0] * c.cross(b).dot(normal) + triangle.normals[1] * a.cross(c).dot(normal) +
                   triangle.normals[2] * b.cross(a).dot(normal);
  const double length = sum.length();
  return length > 0 ? sum / length : triangle_normal(triangle);
}

Box triangle_bounds(const scene::Triangle& triangle) noexcept {
  Box box;
  for (const Vec3& corner : triangle.corners) box.extendBy(corner);
  return box;
}

}  // namespace isl::render
