// The part of each of eight lines inside a convex solid, or a quadric where that is one stretch. The formulas are those
// of the files of the solids, operation by operation, so that a ray gets the same bits alone and among eight. Cases
// that few rays are in, such as a ray along a cylinder's axis, are left to crossings().
#if defined(ISL_RENDERER_SOLIDS_OCTET_INTERVALS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLIDS_OCTET_INTERVALS_INL_H_
#undef ISL_RENDERER_SOLIDS_OCTET_INTERVALS_INL_H_
#else
#define ISL_RENDERER_SOLIDS_OCTET_INTERVALS_INL_H_
#endif

#include "renderer/solids/line_interval.h"
#include "renderer/solids/octet_vector-inl.h"
#include "renderer/solids/quadric_line.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// Ends of an interval of each line, with the surfaces there. Empty unless low < high.
struct OctetIntervals {
  Octet low, high, low_part, high_part;
};

/// As LineInterval's intersection().
[[nodiscard]] HWY_INLINE OctetIntervals intersection(const OctetIntervals& first, const OctetIntervals& second) {
  const OctetMask later = second.low > first.low, earlier = second.high < first.high;
  return {select(later, second.low, first.low), select(earlier, second.high, first.high),
          select(later, second.low_part, first.low_part), select(earlier, second.high_part, first.high_part)};
}

/// As Vec3::length(), which takes another way for lengths whose square has lost digits: those lanes are added to
/// `alone`.
[[nodiscard]] HWY_INLINE Octet length_of(const OctetVector& v, OctetMask& alone) {
  const Octet square = v.dot(v);
  alone = alone | (square < Octet(2 * std::numeric_limits<double>::min()));
  return sqrt(square);
}

/// As within_radius(); `on_surface` are the lines that start on the surface.
[[nodiscard]] inline OctetIntervals within_radius(const OctetVector& offset, const OctetVector& direction,
                                                  const Octet& radius, const OctetMask& on_surface, OctetMask& alone) {
  const Octet zero(0.0), dd = direction.dot(direction), b = offset.dot(direction);
  alone = alone | (dd <= zero);
  const Octet distance = length_of(offset - direction * (b / dd), alone);
  const Octet discriminant = dd * (radius - distance) * (radius + distance);
  const Octet root = sqrt(discriminant);
  const Octet q = zero - (b + copysign(root, b));
  const Octet start = length_of(offset, alone);
  const Octet c = (start - radius) * (start + radius);
  const Octet t0 = select(on_surface, zero, q / dd), t1 = select(on_surface, Octet(-2.0) * b / dd, c / q);
  const OctetMask is_met = (discriminant > zero) | on_surface, in_order = t0 < t1;
  const Octet side(kSide);
  return {select(is_met, select(in_order, t0, t1), Octet(kInfinity)),
          select(is_met, select(in_order, t1, t0), Octet(-kInfinity)), side, side};
}

/// As LineInterval::hold_origin(), where `starts` holds.
[[nodiscard]] HWY_INLINE OctetIntervals holding_origin(OctetIntervals inside, const OctetMask& starts) {
  const Octet zero(0.0);
  inside.low = select(starts, min(inside.low, zero), inside.low);
  inside.high = select(starts, max(inside.high, zero), inside.high);
  return inside;
}

/// The half-space behind a plane.
[[nodiscard]] inline OctetIntervals inside_of_plane(const scene::Solid& solid, const OctetLines& lines,
                                                    const Octet& start_part, OctetMask& alone) {
  const Octet zero(0.0), rise = lines.direction.dot(solid.a), side(kSide);
  alone = alone | equal(rise, zero);
  const Octet t = select(start_part < zero, (Octet(solid.radius_a) - lines.origin.dot(solid.a)) / rise, zero);
  const OctetMask leaves = rise > zero;
  return {select(leaves, Octet(-kInfinity), t), select(leaves, t, Octet(kInfinity)), side, side};
}

[[nodiscard]] inline OctetIntervals inside_of_sphere(const scene::Solid& solid, const OctetLines& lines,
                                                     const Octet& start_part, OctetMask& alone) {
  return within_radius(lines.origin - solid.a, lines.direction, Octet(std::abs(solid.radius_a)),
                       start_part >= Octet(0.0), alone);
}

[[nodiscard]] inline OctetIntervals inside_of_box(const scene::Solid& solid, const OctetLines& lines,
                                                  const Octet& start_part, OctetMask& alone) {
  const Octet* const origin[3] = {&lines.origin.x, &lines.origin.y, &lines.origin.z};
  const Octet* const direction[3] = {&lines.direction.x, &lines.direction.y, &lines.direction.z};
  const Octet zero(0.0);
  const OctetMask starts_here = start_part >= zero;
  OctetIntervals inside;
  for (int axis = 0; axis < 3; ++axis) {
    const Octet& rise = *direction[axis];
    const Octet part_a(2 * axis), part_b(2 * axis + 1), thickness(solid.b[axis] - solid.a[axis]);
    const OctetMask on_a = equal(start_part, part_a), on_b = equal(start_part, part_b);
    const Octet to_a = Octet(solid.a[axis]) - *origin[axis], to_b = Octet(solid.b[axis]) - *origin[axis];
    const Octet a = select(on_a, zero, select(on_b, zero - thickness, to_a)) / rise;
    const Octet b = select(on_b, zero, select(on_a, thickness, to_b)) / rise;
    const OctetMask rises = rise > zero;
    const OctetIntervals slab{select(rises, a, b), select(rises, b, a), select(rises, part_a, part_b),
                              select(rises, part_b, part_a)};
    alone = alone | equal(rise, zero);
    const OctetIntervals held = holding_origin(slab, and_not(on_a | on_b, starts_here));
    inside = axis == 0 ? held : intersection(inside, held);
  }
  return inside;
}

/// The side of a cylinder or cone, endless, and the slab between its ends.
struct OctetTube {
  OctetIntervals side, slab;
};

/// Precondition: the line meets the tube's axis at an angle. As slab_interval().
[[nodiscard]] inline OctetIntervals slab_of(const scene::Solid& solid, const Axis& axis, const OctetLines& lines,
                                            const Octet& start_part, OctetMask& alone) {
  const OctetVector along(axis.along);
  const Octet zero(0.0), cap_a(kCapA), cap_b(kCapB), length(axis.length);
  const OctetMask on_a = equal(start_part, cap_a), on_b = equal(start_part, cap_b);
  const Octet rise = lines.direction.dot(along);
  alone = alone | equal(rise, zero);
  const Octet below_a = (OctetVector(solid.a) - lines.origin).dot(along);
  const Octet below_b = (OctetVector(solid.b) - lines.origin).dot(along);
  const Octet to_a = select(on_a, zero, select(on_b, zero - length, below_a)) / rise;
  const Octet to_b = select(on_b, zero, select(on_a, length, below_b)) / rise;
  const OctetMask in_order = to_a < to_b;
  return holding_origin({select(in_order, to_a, to_b), select(in_order, to_b, to_a), select(in_order, cap_a, cap_b),
                         select(in_order, cap_b, cap_a)},
                        equal(start_part, Octet(kSide)));
}

[[nodiscard]] HWY_INLINE OctetVector across(const Axis& axis, const OctetVector& v) {
  const OctetVector along(axis.along);
  return v - along * v.dot(along);
}

[[nodiscard]] inline OctetIntervals side_of_cylinder(const scene::Solid& solid, const Axis& axis,
                                                     const OctetLines& lines, const OctetMask& on_side,
                                                     OctetMask& alone) {
  return within_radius(across(axis, lines.origin - solid.a), across(axis, lines.direction),
                       Octet(std::abs(solid.radius_a)), on_side, alone);
}

/// The formulas are explained in cone.cpp.
[[nodiscard]] inline OctetIntervals side_of_cone(const scene::Solid& solid, const Axis& axis, const OctetLines& lines,
                                                 const OctetMask& on_side, OctetMask& alone) {
  const Octet zero(0.0), side(kSide), before(-kInfinity), after(kInfinity);
  const Octet slope((solid.radius_b - solid.radius_a) / axis.length);
  const Octet dd = lines.direction.dot(lines.direction);
  alone = alone | (dd <= zero);
  const Octet nearest = (OctetVector((solid.a + solid.b) * 0.5) - lines.origin).dot(lines.direction) / dd;
  const OctetVector from_a = lines.origin - solid.a, from_nearest = from_a + lines.direction * nearest;
  const OctetVector offset{select(on_side, from_a.x, from_nearest.x), select(on_side, from_a.y, from_nearest.y),
                           select(on_side, from_a.z, from_nearest.z)};
  const OctetVector o = across(axis, offset), d = across(axis, lines.direction);
  const Octet radius = Octet(solid.radius_a) + slope * offset.dot(OctetVector(axis.along));
  const Octet widening = slope * lines.direction.dot(OctetVector(axis.along));
  const Octet length = length_of(d, alone);
  const Octet a = (length - abs(widening)) * (length + abs(widening)), b = o.dot(d) - radius * widening;
  const Octet start = length_of(o, alone), c = (start - radius) * (start + radius);
  alone = alone | equal(a, zero);
  const Octet v = length_of(d * radius - o * widening, alone), w = length_of(o.cross(d), alone);
  const OctetMask is_flat = a > zero, widens = widening > zero;
  Octet discriminant = (v - w) * (v + w);
  const OctetMask is_met =
      on_side | and_not(is_flat, all_lanes()) | ((discriminant > zero) & (radius - widening * (b / a) > zero));
  discriminant = select(discriminant > zero, discriminant, zero);
  const Octet q = zero - (b + copysign(sqrt(discriminant), b));
  const Octet t0 = select(on_side, zero, q / a);
  const Octet t1 = select(on_side, Octet(-2.0) * b / a, select(equal(q, zero), zero, c / q));
  // A line steeper than the side meets each nappe once.
  const Octet end = select(on_side, zero, select(widens, max(t0, t1), min(t0, t1)));
  const OctetMask in_order = t0 < t1;
  const Octet low = select(is_flat, select(in_order, t0, t1), select(widens, end, before));
  const Octet high = select(is_flat, select(in_order, t1, t0), select(widens, after, end));
  const Octet shift = select(on_side, zero, nearest);
  return {select(is_met, low + shift, after), select(is_met, high + shift, before), side, side};
}

/// Precondition: the solid is a cylinder or cone with an axis.
[[nodiscard]] inline OctetTube tube_of(const scene::Solid& solid, const OctetLines& lines, const Octet& start_part,
                                       OctetMask& alone) {
  const Axis axis(solid);
  const OctetMask on_side = equal(start_part, Octet(kSide));
  const OctetIntervals side = solid.kind == scene::SolidKind::cylinder
                                  ? side_of_cylinder(solid, axis, lines, on_side, alone)
                                  : side_of_cone(solid, axis, lines, on_side, alone);
  return {side, slab_of(solid, axis, lines, start_part, alone)};
}

/// The tube's inside, between its ends.
[[nodiscard]] HWY_INLINE OctetIntervals closed(const OctetTube& tube, const Octet& start_part) {
  // A line that misses the side misses the tube, wherever it starts.
  const OctetMask on_cap = equal(start_part, Octet(kCapA)) | equal(start_part, Octet(kCapB));
  return intersection(holding_origin(tube.side, on_cap & (tube.side.low < tube.side.high)), tube.slab);
}

/// The crossings of lines with a quadric: none where `is_missed`. A known start counts as one of them.
struct QuadricCrossings {
  Octet near, far;
  OctetMask is_missed, is_hollow;  ///< a line far away is inside a hollow one
};

/// As find_plain_crossings().
[[nodiscard]] inline QuadricCrossings crossings_of_quadric(const PreparedPolynomial& quadric, const OctetLines& lines,
                                                           const Octet& start_part, OctetMask& alone) {
  if (quadric.order != 2) {
    alone = all_lanes();
    return {Octet(0.0), Octet(0.0), all_lanes(), no_lane()};
  }
  const QuadricSizes size(quadric);
  const double* const c = quadric.coefficients.data();
  const auto& [origin, direction] = lines;
  const auto second = [&](const OctetVector& v) HWY_ATTR {
    return Octet(c[0]) * v.x * v.x + Octet(c[4]) * v.y * v.y + Octet(c[7]) * v.z * v.z + Octet(c[1]) * v.x * v.y +
           Octet(c[2]) * v.x * v.z + Octet(c[5]) * v.y * v.z;
  };
  const auto gradient = [&](const OctetVector& p) HWY_ATTR {
    return OctetVector(Octet(2 * c[0]) * p.x + Octet(c[1]) * p.y + Octet(c[2]) * p.z + Octet(c[3]),
                       Octet(c[1]) * p.x + Octet(2 * c[4]) * p.y + Octet(c[5]) * p.z + Octet(c[6]),
                       Octet(c[2]) * p.x + Octet(c[5]) * p.y + Octet(2 * c[7]) * p.z + Octet(c[8]));
  };
  const auto largest = [](const OctetVector& v) HWY_ATTR { return max(max(abs(v.x), abs(v.y)), abs(v.z)); };
  const Octet zero(0.0), half(0.5), rounding(kTermRounding), clear(kClear);
  const OctetMask on_surface = equal(start_part, Octet(kSide));
  const Octet step = largest(direction), start = largest(origin);
  const Octet a = second(direction), a_off = Octet(kTermRounding * size.second) * step * step;
  const Octet b_start = half * direction.dot(gradient(origin));
  const Octet b_start_off = clear * rounding * (Octet(2 * size.second) * start + Octet(size.first)) * step;
  const Octet foot_t = zero - origin.dot(direction) / direction.dot(direction);
  const OctetVector foot = origin + direction * foot_t;
  const Octet r = largest(foot), slope = Octet(2 * size.second) * r + Octet(size.first);
  const Octet b = half * direction.dot(gradient(foot)), b_off = rounding * (slope + Octet(size.second) * start) * step;
  const Octet value = second(foot) + Octet(c[3]) * foot.x + Octet(c[6]) * foot.y + Octet(c[8]) * foot.z + Octet(c[9]);
  const Octet value_off =
      rounding * ((Octet(size.second) * r + Octet(size.first)) * r + Octet(size.constant) + slope * start);
  const Octet square = b * b, product = a * value, discriminant = square - product;
  const Octet off = Octet(2.0) * abs(b) * b_off + abs(a) * value_off + abs(value) * a_off +
                    rounding * (square + abs(product)) + b_off * b_off + a_off * value_off;
  const Octet q = zero - (b + copysign(sqrt(discriminant), b));
  const Octet s1 = q / a, s2 = value / q, near = min(s1, s2), far = max(s1, s2);
  const Octet doubt = clear * rounding * (abs(foot_t) + max(abs(near), abs(far)));
  const Octet t_near = foot_t + near, t_far = foot_t + far;
  const OctetMask is_missed = and_not(on_surface, discriminant < zero - off);
  const OctetMask is_plain = (discriminant > clear * off) & (abs(t_near) > doubt) & (abs(t_far) > doubt);
  const OctetMask is_clear = (abs(a) > clear * a_off) &
                             ((on_surface & (abs(b_start) > b_start_off)) | is_missed | and_not(on_surface, is_plain));
  alone = alone | and_not(is_clear, all_lanes());
  const Octet other = Octet(-2.0) * b_start / a;
  return {select(on_surface, min(other, zero), t_near), select(on_surface, max(other, zero), t_far), is_missed,
          a < zero};
}

/// Lines that leave the inside and come back go to `alone`, too.
[[nodiscard]] inline OctetIntervals inside_of_quadric(const PreparedPolynomial& quadric, const OctetLines& lines,
                                                      const Octet& start_part, OctetMask& alone) {
  const QuadricCrossings found = crossings_of_quadric(quadric, lines, start_part, alone);
  alone = alone | and_not(found.is_missed, found.is_hollow);
  const Octet before(-kInfinity), after(kInfinity), side(kSide);
  return {select(found.is_missed, select(found.is_hollow, before, after), found.near),
          select(found.is_missed, select(found.is_hollow, after, before), found.far), side, side};
}

/// The part of lines in the solid's space that is inside it. `start_part` is the surface of the solid that a line
/// starts on, or below 0; `alone` gets the lines that are left to crossings(). Precondition:
/// meets_octets(solid).
[[nodiscard]] inline OctetIntervals inside_of(const scene::Solid& solid, const SolidDetails& details,
                                              const OctetLines& lines, const Octet& start_part, OctetMask& alone) {
  switch (solid.kind) {
    case scene::SolidKind::quadric:
      return inside_of_quadric(details.polynomials[solid.detail], lines, start_part, alone);
    case scene::SolidKind::plane: return inside_of_plane(solid, lines, start_part, alone);
    case scene::SolidKind::sphere: return inside_of_sphere(solid, lines, start_part, alone);
    case scene::SolidKind::box: return inside_of_box(solid, lines, start_part, alone);
    default: return closed(tube_of(solid, lines, start_part, alone), start_part);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
