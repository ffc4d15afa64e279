// polygon: a flat area between closed contours. A point of its plane is in it if a half-line from there crosses the
// edges an odd number of times (even-odd rule: a contour within a contour is a hole). Edges hold their lower end and
// not their upper one, so that a corner counts once.
#include "renderer/solids/solid_type.h"

#include <cmath>

namespace isl::render {
namespace {

/// A normal of the polygon's plane: that of the largest of the triangles between the first point and an edge, oriented
/// like that of the first triangle.
Vec3 across(const std::vector<Vec3>& points) {
  Vec3 widest(0), first(0);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Vec3 own = (points[i] - points[0]).cross(points[i + 1] - points[0]);
    if (first == Vec3(0)) first = own;
    if (own.length2() > widest.length2()) widest = own;
  }
  return widest.dot(first) < 0 ? -widest : widest;
}

}  // namespace

PreparedPolygon prepare(const scene::Polygon& polygon) {
  PreparedPolygon result;
  const std::vector<Vec3>& points = polygon.points;
  if (points.empty()) return result;
  result.normal = across(points);
  const double length = result.normal.length();
  if (!(length > 0)) return result;
  result.normal /= length;
  result.anchor = points[0];
  for (const Vec3& point : points) result.box.extendBy(point);
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(result.normal[i]) > std::abs(result.normal[axis])) axis = i;
  }
  result.axis_u = (axis + 1) % 3;
  result.axis_v = (axis + 2) % 3;
  const auto seen = [&](const Vec3& p) { return PlanePoint{p[result.axis_u], p[result.axis_v]}; };
  for (std::size_t first = 0; first < points.size();) {
    std::size_t i = first;
    do {
      if (i + 1 == points.size()) return result;
      result.starts.push_back(seen(points[i]));
      result.ends.push_back(seen(points[i + 1]));
      ++i;
    } while (points[i] != points[first]);
    first = i + 1;
  }
  return result;
}

namespace {

Crossings polygon_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                            std::uint32_t start_part, const SolidDetails& details) noexcept {
  const PreparedPolygon& polygon = details.polygons[solid.detail];
  Crossings result;
  const double rise = polygon.normal.dot(direction);
  if (start_part == kSide || rise == 0) return result;
  const double t = polygon.normal.dot(polygon.anchor - origin) / rise;
  const Vec3 point = origin + direction * t;
  const double u = point[polygon.axis_u], v = point[polygon.axis_v];
  bool is_in = false;
  for (std::size_t i = 0; i < polygon.starts.size(); ++i) {
    const PlanePoint& a = polygon.starts[i];
    const PlanePoint& b = polygon.ends[i];
    if ((a.v <= v) == (b.v <= v)) continue;
    // The side of the edge is computed from its lower end, so that both directions of an edge give the same answer.
    const PlanePoint& low = a.v <= b.v ? a : b;
    const PlanePoint& high = a.v <= b.v ? b : a;
    if ((high.u - low.u) * (v - low.v) > (u - low.u) * (high.v - low.v)) is_in = !is_in;
  }
  if (is_in) result.add(t, kSide);
  return result;
}

Vec3 polygon_normal(const scene::Solid& solid, std::uint32_t, const Vec3&, const SolidDetails& details) noexcept {
  return details.polygons[solid.detail].normal;
}

Box polygon_bounds(const scene::Solid& solid, const SolidDetails& details) noexcept {
  return details.polygons[solid.detail].box;
}

double polygon_support(const scene::Database& database, const scene::Solid& solid, const Vec3& direction) {
  return farthest(database.polygons[solid.detail].points, direction);
}

double polygon_size(const scene::Database& database, const scene::Solid& solid) {
  double size = 0;
  for (const Vec3& point : database.polygons[solid.detail].points) size = std::max(size, largest(point));
  return size;
}

}  // namespace

constinit const SolidType kinds::polygon{.crossings = polygon_crossings,
                                         .is_open_surface = always_sheet,
                                         .normal = polygon_normal,
                                         .bounds = polygon_bounds,
                                         .support = polygon_support,
                                         .is_inside = never_inside,
                                         .size = polygon_size};

}  // namespace isl::render
