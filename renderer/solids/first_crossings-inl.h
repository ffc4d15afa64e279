// The first crossing of eight rays at once with the solids that most scenes are made of. The formulas are those of
// crossings() in the files of the solids, operation by operation, so that a ray gets the same bits alone and among
// eight. Cases that few rays are in, such as a ray along a cylinder's axis, are left to crossings().
#if defined(ISL_RENDERER_SOLIDS_FIRST_CROSSINGS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLIDS_FIRST_CROSSINGS_INL_H_
#undef ISL_RENDERER_SOLIDS_FIRST_CROSSINGS_INL_H_
#else
#define ISL_RENDERER_SOLIDS_FIRST_CROSSINGS_INL_H_
#endif

#include "renderer/solids/line_interval.h"
#include "renderer/solids/octet_vector-inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// The first crossings beyond t = 0.
struct FirstCrossings {
  Octet t;          ///< infinite: none
  Octet part;       ///< the surface that is crossed
  OctetMask alone;  ///< rays that are left to crossings()

  HWY_INLINE FirstCrossings() : part(kSide), alone(no_lane()) {}
};

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

/// As closed_crossings().
[[nodiscard]] HWY_INLINE FirstCrossings first_end(const OctetIntervals& inside) {
  const Octet zero(0.0);
  const OctetMask enters = inside.low > zero, ahead = (inside.low < inside.high) & (inside.high > zero);
  FirstCrossings result;
  result.t = select(ahead, select(enters, inside.low, inside.high), Octet(kInfinity));
  result.part = select(enters, inside.low_part, inside.high_part);
  return result;
}

/// As Vec3::length(), which takes another way for lengths whose square has lost digits: those lanes are added to
/// `alone`.
[[nodiscard]] HWY_INLINE Octet length_of(const OctetVector& v, OctetMask& alone) {
  const Octet square = v.dot(v);
  alone = alone | (square < Octet(2 * std::numeric_limits<double>::min()));
  return sqrt(square);
}

/// As within_radius(); `on_surface` are the lines that start on the surface.
[[nodiscard]] HWY_INLINE OctetIntervals within_radius(const OctetVector& offset, const OctetVector& direction,
                                                      const Octet& radius, const OctetMask& on_surface,
                                                      OctetMask& alone) {
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

[[nodiscard]] HWY_INLINE FirstCrossings first_of_plane(const scene::Solid& solid, const OctetLines& lines,
                                                       const Octet& start_part) {
  const Octet rise = lines.direction.dot(solid.a);
  const Octet t = (Octet(solid.radius_a) - lines.origin.dot(solid.a)) / rise;
  // A line parallel to the plane has an infinite t or NaN; neither is a crossing.
  FirstCrossings result;
  result.t = select((start_part < Octet(0.0)) & (t > Octet(0.0)), t, Octet(kInfinity));
  return result;
}

[[nodiscard]] HWY_INLINE FirstCrossings first_of_sphere(const scene::Solid& solid, const OctetLines& lines,
                                                        const Octet& start_part) {
  OctetMask alone = no_lane();
  FirstCrossings result = first_end(within_radius(lines.origin - solid.a, lines.direction,
                                                  Octet(std::abs(solid.radius_a)), start_part >= Octet(0.0), alone));
  result.alone = alone;
  return result;
}

[[nodiscard]] HWY_INLINE FirstCrossings first_of_box(const scene::Solid& solid, const OctetLines& lines,
                                                     const Octet& start_part) {
  const Octet* const origin[3] = {&lines.origin.x, &lines.origin.y, &lines.origin.z};
  const Octet* const direction[3] = {&lines.direction.x, &lines.direction.y, &lines.direction.z};
  const Octet zero(0.0);
  const OctetMask starts_here = start_part >= zero;
  OctetMask alone = no_lane();
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
  FirstCrossings result = first_end(inside);
  result.alone = alone;
  return result;
}

/// As open_crossings().
[[nodiscard]] HWY_INLINE FirstCrossings first_of_open(const OctetIntervals& side, const OctetIntervals& slab) {
  const Octet zero(0.0), none(kInfinity);
  const OctetMask is_met = (side.low < side.high) & (slab.low < slab.high);
  const auto seen = [&](const Octet& t) HWY_ATTR { return is_met & (t > zero) & (slab.low <= t) & (t <= slab.high); };
  FirstCrossings result;
  result.t = select(seen(side.low), side.low, select(seen(side.high), side.high, none));
  return result;
}

[[nodiscard]] HWY_INLINE FirstCrossings first_of_cylinder(const scene::Solid& solid, const OctetLines& lines,
                                                          const Octet& start_part) {
  const Axis axis(solid);
  const OctetVector along(axis.along);
  const Octet zero(0.0), cap_a(kCapA), cap_b(kCapB), length(axis.length);
  const OctetMask on_side = equal(start_part, Octet(kSide)), on_a = equal(start_part, cap_a),
                  on_b = equal(start_part, cap_b);
  const auto across = [&](const OctetVector& v) HWY_ATTR { return v - along * v.dot(along); };
  OctetMask alone = no_lane();
  const OctetIntervals side = within_radius(across(lines.origin - solid.a), across(lines.direction),
                                            Octet(std::abs(solid.radius_a)), on_side, alone);
  // As slab_interval().
  const Octet rise = lines.direction.dot(along);
  alone = alone | equal(rise, zero);
  const Octet below_a = (OctetVector(solid.a) - lines.origin).dot(along);
  const Octet below_b = (OctetVector(solid.b) - lines.origin).dot(along);
  const Octet to_a = select(on_a, zero, select(on_b, zero - length, below_a)) / rise;
  const Octet to_b = select(on_b, zero, select(on_a, length, below_b)) / rise;
  const OctetMask in_order = to_a < to_b;
  const OctetIntervals slab = holding_origin({select(in_order, to_a, to_b), select(in_order, to_b, to_a),
                                              select(in_order, cap_a, cap_b), select(in_order, cap_b, cap_a)},
                                             on_side);
  // A line that misses the side misses the cylinder, wherever it starts.
  const OctetIntervals held_side = holding_origin(side, (on_a | on_b) & (side.low < side.high));
  FirstCrossings result = solid.open ? first_of_open(side, slab) : first_end(intersection(held_side, slab));
  result.alone = alone;
  return result;
}

[[nodiscard]] HWY_INLINE FirstCrossings first_of_disc(const scene::Solid& solid, const OctetLines& lines,
                                                      const Octet& start_part) {
  const Octet zero(0.0), rise = lines.direction.dot(solid.b);
  const Octet t = (OctetVector(solid.a) - lines.origin).dot(solid.b) / rise;
  FirstCrossings result;
  const Octet distance = length_of(lines.origin + lines.direction * t - solid.a, result.alone);
  const OctetMask is_seen = (distance >= Octet(solid.radius_b)) & (distance <= Octet(solid.radius_a));
  result.t = select(is_seen & (t > zero) & (start_part < zero), t, Octet(kInfinity));
  return result;
}

/// True if first_crossings() takes the solid.
[[nodiscard]] inline bool has_first_crossings(const scene::Solid& solid) {
  switch (solid.kind) {
    case scene::SolidKind::plane:
    case scene::SolidKind::sphere:
    case scene::SolidKind::disc: return true;
    case scene::SolidKind::cylinder: return solid.a != solid.b;
    case scene::SolidKind::box: return !is_open_surface(solid);
    default: return false;
  }
}

/// The first crossings of lines in the solid's space. `start_part` is the surface of the solid that a line starts on,
/// or below 0. Precondition: has_first_crossings(solid).
[[nodiscard]] HWY_INLINE FirstCrossings first_crossings(const scene::Solid& solid, const OctetLines& lines,
                                                        const Octet& start_part) {
  switch (solid.kind) {
    case scene::SolidKind::plane: return first_of_plane(solid, lines, start_part);
    case scene::SolidKind::sphere: return first_of_sphere(solid, lines, start_part);
    case scene::SolidKind::disc: return first_of_disc(solid, lines, start_part);
    case scene::SolidKind::cylinder: return first_of_cylinder(solid, lines, start_part);
    default: return first_of_box(solid, lines, start_part);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
