// triangle, smooth_triangle: flat between three corners.
//
// With the corners A, B, C seen from the line's origin, the line passes an edge on the side that the sign of
// (B × A)·d tells (Plücker coordinates). Swapping the ends of an edge gives exactly the opposite number, so that of two
// triangles which share it a line that does not meet one meets the other: meshes have no cracks. A line within the
// plane meets nothing.
#include "renderer/solids/solid_type.h"

#include <algorithm>
#include <cmath>

namespace isl::render {
namespace {

/// A normal of any length, to the side that is outside in POV-Ray.
Vec3 across(const scene::Triangle& triangle) {
  return (triangle.corners[0] - triangle.corners[1]).cross(triangle.corners[2] - triangle.corners[1]);
}

Crossings triangle_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                             std::uint32_t start_part, const SolidDetails& details) noexcept {
  const scene::Triangle& triangle = details.triangles[solid.detail];
  Crossings result;
  if (start_part == kSide) return result;
  const Vec3 a = triangle.corners[0] - origin, b = triangle.corners[1] - origin, c = triangle.corners[2] - origin;
  const double u = c.cross(b).dot(direction), v = a.cross(c).dot(direction), w = b.cross(a).dot(direction);
  const bool is_met = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
  if (!is_met || (u == 0 && v == 0 && w == 0)) return result;
  const Vec3 normal = across(triangle);
  const double rise = normal.dot(direction);
  if (rise == 0) return result;
  // The distance is computed from the nearest corner, so that far corners of large triangles cost no digits.
  const double da = a.length2(), db = b.length2(), dc = c.length2();
  const Vec3& nearest = da <= db && da <= dc ? a : (db <= dc ? b : c);
  result.add(normal.dot(nearest) / rise, kSide);
  return result;
}

Vec3 triangle_normal(const scene::Solid& solid, std::uint32_t, const Vec3&, const SolidDetails& details) noexcept {
  return across(details.triangles[solid.detail]).normalized();
}

/// The corners' normals, weighted by the areas between the point and the opposite edges.
Vec3 smooth_normal(const scene::Solid& solid, std::uint32_t, const Vec3& point, const SolidDetails& details) noexcept {
  const scene::Triangle& triangle = details.triangles[solid.detail];
  const Vec3 normal = across(triangle);
  const Vec3 a = triangle.corners[0] - point, b = triangle.corners[1] - point, c = triangle.corners[2] - point;
  const Vec3 sum = triangle.normals[0] * c.cross(b).dot(normal) + triangle.normals[1] * a.cross(c).dot(normal) +
                   triangle.normals[2] * b.cross(a).dot(normal);
  const double length = sum.length();
  return length > 0 ? sum / length : normal.normalized();
}

Box triangle_bounds(const scene::Solid& solid, const SolidDetails& details) noexcept {
  Box box;
  for (const Vec3& corner : details.triangles[solid.detail].corners) box.extendBy(corner);
  return box;
}

double triangle_support(const scene::Database& database, const scene::Solid& solid, const Vec3& direction) {
  return farthest(database.triangles[solid.detail].corners, direction);
}

double triangle_size(const scene::Database& database, const scene::Solid& solid) {
  double size = 0;
  for (const Vec3& corner : database.triangles[solid.detail].corners) size = std::max(size, largest(corner));
  return size;
}

constexpr SolidType kTriangle{.crossings = triangle_crossings,
                              .is_open_surface = always_sheet,
                              .normal = triangle_normal,
                              .bounds = triangle_bounds,
                              .support = triangle_support,
                              .is_inside = never_inside,
                              .size = triangle_size};

constexpr SolidType smooth(SolidType type) {
  type.shading_normal = smooth_normal;
  return type;
}

}  // namespace

constinit const SolidType kinds::triangle = kTriangle;
constinit const SolidType kinds::smooth_triangle = smooth(kTriangle);

}  // namespace isl::render
