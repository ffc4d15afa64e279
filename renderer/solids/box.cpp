// box: the points with a ≤ p ≤ b in every coordinate; three slabs, each between two faces. Part 2·axis is the face at
// a, 2·axis + 1 the one at b.
//
// A box without thickness along an axis is the open surface that POV-Ray makes of it: a rectangle, crossed once.
#include "renderer/solids/line_interval.h"
#include "renderer/solids/solid_type.h"

#include <algorithm>
#include <limits>

namespace isl::render {
namespace {

std::uint32_t face(int axis, int end) { return static_cast<std::uint32_t>(2 * axis + end); }

/// The interval between two faces. Each plane's root is computed relative to its own face, so that a far face costs a
/// near one no digits; from a start on one face, the other is the thickness away. A start on a face of another axis is
/// certainly within this slab.
LineInterval face_slab(const scene::Solid& solid, int axis, const Vec3& origin, const Vec3& direction,
                       std::uint32_t start_part) {
  const double rise = direction[axis];
  double to_a = solid.a[axis] - origin[axis], to_b = solid.b[axis] - origin[axis];
  const bool starts_on_a = start_part == face(axis, 0), starts_on_b = start_part == face(axis, 1);
  if (starts_on_a) to_a = 0, to_b = solid.b[axis] - solid.a[axis];
  if (starts_on_b) to_a = solid.a[axis] - solid.b[axis], to_b = 0;
  const bool starts_on_another = start_part != kNoPart && !starts_on_a && !starts_on_b;
  LineInterval slab;
  if (rise == 0) {
    if (!(to_a < 0 && to_b > 0) && !starts_on_another) slab = LineInterval::none();
    return slab;
  }
  const LineEnd a{to_a / rise, face(axis, 0), starts_on_a}, b{to_b / rise, face(axis, 1), starts_on_b};
  slab = rise > 0 ? LineInterval{a, b} : LineInterval{b, a};
  if (starts_on_another) slab.hold_origin();
  return slab;
}

/// The axis along which the box has no thickness, or −1.
int flat_axis(const scene::Solid& solid) {
  for (int axis = 0; axis < 3; ++axis) {
    if (solid.a[axis] == solid.b[axis]) return axis;
  }
  return -1;
}

Crossings rectangle_crossings(const scene::Solid& solid, int axis, const Vec3& origin, const Vec3& direction,
                              std::uint32_t start_part) {
  Crossings result;
  if (start_part != kNoPart || direction[axis] == 0) return result;
  const double t = (solid.a[axis] - origin[axis]) / direction[axis];
  for (int other = 0; other < 3; ++other) {
    if (other == axis) continue;
    const double p = origin[other] + t * direction[other];
    if (!(p >= solid.a[other] && p <= solid.b[other])) return result;
  }
  result.add(t, face(axis, 0));
  return result;
}

/// True if the line's part beyond t = 0 certainly misses the box: most do, and that is told in less time than where one
/// meets it. A line that only touches it is left to the others.
bool passes_by(const scene::Solid& solid, const Vec3& origin, const Vec3& direction) {
  double from = 0, to = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0) continue;
    const double a = (solid.a[axis] - origin[axis]) / direction[axis];
    const double b = (solid.b[axis] - origin[axis]) / direction[axis];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return from > to;
}

Crossings box_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction, std::uint32_t start_part,
                        const SolidDetails&) noexcept {
  if (const int axis = flat_axis(solid); axis >= 0) {
    return rectangle_crossings(solid, axis, origin, direction, start_part);
  }
  if (start_part == kNoPart && passes_by(solid, origin, direction)) return {};
  LineInterval inside = face_slab(solid, 0, origin, direction, start_part);
  inside = intersection(inside, face_slab(solid, 1, origin, direction, start_part));
  inside = intersection(inside, face_slab(solid, 2, origin, direction, start_part));
  return closed_crossings(inside);
}

bool is_flat_box(const scene::Solid& solid) noexcept { return flat_axis(solid) >= 0; }

Vec3 box_normal(const scene::Solid&, std::uint32_t part, const Vec3&, const SolidDetails&) noexcept {
  Vec3 normal(0);
  normal[part / 2] = part % 2 == 0 ? -1 : 1;
  return normal;
}

Box box_bounds(const scene::Solid& solid, const SolidDetails&) noexcept { return {solid.a, solid.b}; }

double box_support(const scene::Database&, const scene::Solid& solid, const Vec3& direction) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += std::max(direction[i] * solid.a[i], direction[i] * solid.b[i]);
  return sum;
}

bool is_in_box(const scene::Database&, const scene::Solid& solid, const Vec3& point) {
  for (int i = 0; i < 3; ++i) {
    if (point[i] < solid.a[i] || point[i] > solid.b[i]) return false;
  }
  return true;
}

Coordinates coordinates_of_box(const scene::Solid& solid, const Vec3& point, const Vec3&) noexcept {
  return box_coordinates(solid.a, solid.b, point);
}

}  // namespace

constinit const SolidType kinds::box{.crossings = box_crossings,
                                     .is_open_surface = is_flat_box,
                                     .normal = box_normal,
                                     .bounds = box_bounds,
                                     .support = box_support,
                                     .is_inside = is_in_box,
                                     .coordinates = coordinates_of_box};

}  // namespace isl::render
