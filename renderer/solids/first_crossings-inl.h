// The first crossing of eight rays at once with the solids that most scenes are made of. The formulas are those of
// crossings() in the files of the solids, operation by operation, so that a ray gets the same bits alone and among
// eight. Cases that few rays are in, such as a ray along a cylinder's axis, are left to crossings().
#if defined(ISL_RENDERER_SOLIDS_FIRST_CROSSINGS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLIDS_FIRST_CROSSINGS_INL_H_
#undef ISL_RENDERER_SOLIDS_FIRST_CROSSINGS_INL_H_
#else
#define ISL_RENDERER_SOLIDS_FIRST_CROSSINGS_INL_H_
#endif

#include "renderer/solids/octet_intervals-inl.h"
#include "renderer/solids/octet_solids.h"
#include "renderer/solids/roots_of_solid-inl.h"

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

/// As closed_crossings().
[[nodiscard]] HWY_INLINE FirstCrossings first_end(const OctetIntervals& inside) {
  const Octet zero(0.0);
  const OctetMask enters = inside.low > zero, ahead = (inside.low < inside.high) & (inside.high > zero);
  FirstCrossings result;
  result.t = select(ahead, select(enters, inside.low, inside.high), Octet(kInfinity));
  result.part = select(enters, inside.low_part, inside.high_part);
  return result;
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

/// As open_crossings().
[[nodiscard]] HWY_INLINE FirstCrossings first_of_open(const OctetTube& tube) {
  const OctetIntervals &side = tube.side, &slab = tube.slab;
  const Octet zero(0.0), none(kInfinity);
  const OctetMask is_met = (side.low < side.high) & (slab.low < slab.high);
  const auto seen = [&](const Octet& t) HWY_ATTR { return is_met & (t > zero) & (slab.low <= t) & (t <= slab.high); };
  FirstCrossings result;
  result.t = select(seen(side.low), side.low, select(seen(side.high), side.high, none));
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

[[nodiscard]] inline FirstCrossings first_of_quadric(const PreparedPolynomial& quadric, const OctetLines& lines,
                                                     const Octet& start_part) {
  const Octet zero(0.0);
  FirstCrossings result;
  const QuadricCrossings found = crossings_of_quadric(quadric, lines, start_part, result.alone);
  const Octet first = select(found.near > zero, found.near, found.far);
  result.t = select(and_not(found.is_missed, first > zero), first, Octet(kInfinity));
  return result;
}

[[nodiscard]] HWY_INLINE FirstCrossings first_of_roots(const scene::Solid& solid, const SolidDetails& details,
                                                       const OctetLines& lines, const Octet& start_part) {
  const OctetStretch all{Octet(0.0), Octet(kInfinity), Octet(kInfinity)};
  const OctetRoots roots = roots_of_solid(solid, details, lines, start_part, all, 1);
  FirstCrossings result;
  result.t = roots.t[0];
  result.alone = roots.alone;
  return result;
}

/// The first crossings of lines in the solid's space. `start_part` is the surface of the solid that a line starts on,
/// or below 0. Precondition: has_first_crossings(solid).
[[nodiscard]] HWY_INLINE FirstCrossings first_crossings(const scene::Solid& solid, const SolidDetails& details,
                                                        const OctetLines& lines, const Octet& start_part) {
  if (solid.kind == scene::SolidKind::plane) return first_of_plane(solid, lines, start_part);
  if (solid.kind == scene::SolidKind::disc) return first_of_disc(solid, lines, start_part);
  if (solid.kind == scene::SolidKind::quadric)
    return first_of_quadric(details.polynomials[solid.detail], lines, start_part);
  if (has_octet_roots(solid)) return first_of_roots(solid, details, lines, start_part);
  OctetMask alone = no_lane();
  FirstCrossings result = is_open_tube(solid) ? first_of_open(tube_of(solid, lines, start_part, alone))
                                              : first_end(inside_of(solid, details, lines, start_part, alone));
  result.alone = alone;
  return result;
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
