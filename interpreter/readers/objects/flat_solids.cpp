// Flat pieces: triangle, smooth_triangle, polygon.
#include "interpreter/expressions.h"
#include "interpreter/readers/objects/solid_draft.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/records.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace isl::interpreter {
namespace {

using scene::SolidKind;
using scene::Triangle;
using scene::Vec3;

/// The tolerated distance of a polygon's points from their common plane, relative to its size: it allows for the few
/// decimals that scenes write.
constexpr double kPlanar = 1e-4;

/// As POV-Ray does, a degenerate triangle is left out with a warning.
void add_triangle(ElementStream& stream, ObjectDraft& draft, SolidKind kind, const Triangle& triangle) {
  Context& context = stream.context();
  const auto detail = static_cast<std::uint32_t>(context.database.triangles.size());
  context.database.triangles.push_back(triangle);
  add_solid(stream, draft, {.kind = kind, .detail = detail}, sizeof(Triangle));
}

/// The triangle's unit normal; zero if the corners lie on a line.
Vec3 normal_of(const std::array<Vec3, 3>& corners) {
  const Vec3 a = corners[1] - corners[0], b = corners[2] - corners[0];
  const Vec3 across = a.cross(b);
  const bool is_degenerate = !(across.length() > 1e-14 * std::max(a.dot(a), b.dot(b)));
  return is_degenerate ? Vec3(0) : across / across.length();
}

}  // namespace

void read_triangle(ElementStream& stream, ObjectDraft& draft) {
  if (read_copy(stream, draft)) return;
  Triangle triangle;
  for (Vec3& corner : triangle.corners) {
    corner = read_vector(stream, "a corner of the triangle");
    if (&corner != &triangle.corners.back()) stream.accept_comma();
  }
  const Vec3 normal = normal_of(triangle.corners);
  triangle.normals.fill(normal);
  if (normal == Vec3(0)) return leave_out(stream, draft, "the corners of this triangle lie on a line");
  add_triangle(stream, draft, SolidKind::triangle, triangle);
}

void read_smooth_triangle(ElementStream& stream, ObjectDraft& draft) {
  if (read_copy(stream, draft)) return;
  Triangle triangle;
  for (std::size_t i = 0; i < 3; ++i) {
    triangle.corners[i] = read_vector(stream, "a corner of the triangle");
    stream.accept_comma();
    triangle.normals[i] = read_vector(stream, "the normal at the corner");
    if (i < 2) stream.accept_comma();
  }
  const Vec3 normal = normal_of(triangle.corners);
  if (normal == Vec3(0)) return leave_out(stream, draft, "the corners of this triangle lie on a line");
  // Normals on both sides of the triangle have no smooth surface between them.
  const double side = triangle.normals[0].dot(normal);
  for (Vec3& n : triangle.normals) {
    if (!(n.dot(normal) * side > 0))
      return leave_out(stream, draft, "the normals of this triangle lie along it or on different sides");
    n /= n.length();
  }
  add_triangle(stream, draft, SolidKind::smooth_triangle, triangle);
}

namespace {

/// Ends each contour with its first point.
std::vector<Vec3> closed(ElementStream& stream, const std::vector<Vec3>& points) {
  std::vector<Vec3> result;
  std::size_t first = 0;  // start of the contour in `result`
  for (const Vec3& point : points) {
    result.push_back(point);
    const bool is_closed = result.size() > first + 1 && (point - result[first]).length() < kTolerance;
    if (is_closed) first = result.size();
  }
  if (first == result.size()) return result;
  stream.context().warn(stream.span(),
                        "this polygon is not closed; its last point is joined to the first of its contour");
  result.push_back(result[first]);
  return result;
}

/// The unit normal of the plane through the first point and the first two that are not collinear with it; zero if all
/// points are collinear.
Vec3 normal_of(const std::vector<Vec3>& points) {
  std::size_t i = 1;
  while (i < points.size() && !((points[i] - points[0]).length() > kTolerance)) ++i;
  for (std::size_t j = i + 1; j < points.size(); ++j) {
    const Vec3 normal = normal_of(std::array{points[0], points[i], points[j]});
    if (normal != Vec3(0)) return normal;
  }
  return Vec3(0);
}

/// As in POV-Ray, points off the plane are projected onto it.
void flatten(ElementStream& stream, std::vector<Vec3>& points, const Vec3& normal) {
  const Vec3 origin = points[0];
  double farthest = 0, size = 0;
  for (Vec3& point : points) {
    const double distance = (point - origin).dot(normal);
    farthest = std::max(farthest, std::abs(distance));
    size = std::max(size, (point - origin).length());
    point -= normal * distance;
  }
  if (farthest > kPlanar * size)
    stream.context().warn(
        stream.span(),
        "the points of this polygon do not lie in one plane; they are projected onto that of the first three");
}

}  // namespace

void read_polygon(ElementStream& stream, ObjectDraft& draft) {
  if (read_copy(stream, draft)) return;
  Context& context = stream.context();
  const SourceSpan span = stream.peek().span;
  const double number = read_number(stream, "the number of points of the polygon");
  if (!(number >= 3)) context.fail(span, fmt::format("a polygon needs at least 3 points, found {:g}", number));
  const auto count = static_cast<std::size_t>(std::min(number, context.options.limits.max_primitives));
  std::vector<Vec3> points;
  while (points.size() < count) {
    stream.accept_comma();
    make_room_to_append(context, stream.span(), points);
    points.push_back(read_vector(stream, "a point of the polygon"));
  }
  points = closed(stream, points);
  const Vec3 normal = normal_of(points);
  if (normal == Vec3(0)) return leave_out(stream, draft, "the points of this polygon lie on a line");
  flatten(stream, points, normal);
  const std::size_t bytes = sizeof(scene::Polygon) + points.size() * sizeof(Vec3);
  const auto detail = static_cast<std::uint32_t>(context.database.polygons.size());
  context.database.polygons.push_back({std::move(points)});
  add_solid(stream, draft, {.kind = SolidKind::polygon, .detail = detail}, bytes);
}

}  // namespace isl::interpreter
