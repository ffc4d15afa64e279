// The part of a line inside a convex set: one interval of t, with the surface at each end. The solids that use it are
// intersections of such sets (a cylinder: an infinite cylinder and a slab), so a closed one always has either no
// crossing or one entering and one leaving crossing: parity holds for every rounding.
#pragma once

#include "renderer/solids/capped.h"

#include <algorithm>
#include <limits>

namespace isl::render {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// One end of an interval. `known`: the end is the root at t = 0, on the surface where the ray starts.
struct LineEnd {
  double t = 0;
  std::uint32_t part = kNoPart;
  bool known = false;
};

/// Open interval (low, high) of t; infinite ends have no part. Empty unless low.t < high.t.
struct LineInterval {
  LineEnd low{-kInfinity};
  LineEnd high{kInfinity};

  [[nodiscard]] bool empty() const { return !(low.t < high.t); }

  static LineInterval none() { return {{kInfinity}, {-kInfinity}}; }
  static LineInterval between(LineEnd a, LineEnd b) { return a.t < b.t ? LineInterval{a, b} : LineInterval{b, a}; }
  static LineInterval from(LineEnd a) { return {a, {kInfinity}}; }
  static LineInterval up_to(LineEnd b) { return {{-kInfinity}, b}; }

  /// Extends the closed interval to t = 0. For a set that certainly contains the start on another surface of the same
  /// solid, though its rounded position may be an ulp outside.
  void hold_origin() {
    low.t = std::min(low.t, 0.0);
    high.t = std::max(high.t, 0.0);
  }
};

/// The intersection of two intervals. Where both have equal ends, the end of the first is kept.
[[nodiscard]] inline LineInterval intersection(const LineInterval& first, const LineInterval& second) {
  return {second.low.t > first.low.t ? second.low : first.low, second.high.t < first.high.t ? second.high : first.high};
}

/// The ends of a solid's interval that are crossings to report: finite and not the known start.
[[nodiscard]] inline Crossings closed_crossings(const LineInterval& inside) {
  Crossings result;
  if (inside.empty()) return result;
  for (const LineEnd& end : {inside.low, inside.high}) {
    if (end.known || end.part == kNoPart) continue;
    result.add(end.t, end.part);
  }
  return result;
}

/// The crossings of a tube without caps: the ends of the side's interval that lie within the slab.
[[nodiscard]] inline Crossings open_crossings(const LineInterval& side, const LineInterval& slab) {
  Crossings result;
  if (side.empty() || slab.empty()) return result;
  for (const LineEnd& end : {side.low, side.high}) {
    if (end.known || end.part == kNoPart || end.t < slab.low.t || end.t > slab.high.t) continue;
    result.add(end.t, end.part);
  }
  return result;
}

/// A solid's axis: from `a` along the unit vector `along` for `length`; `valid` is false where a = b.
struct Axis {
  Vec3 along{0};
  double length = 0;
  bool valid = false;

  explicit Axis(const scene::Solid& solid) {
    const Vec3 span = solid.b - solid.a;
    length = span.length();
    valid = length > 0;
    if (valid) along = span / length;
  }
  /// The component of v perpendicular to the axis.
  [[nodiscard]] Vec3 across(const Vec3& v) const { return v - along * v.dot(along); }
};

/// The interval between the planes of the two ends. Each plane's root is computed relative to its own end (o − a, o −
/// b), so that a far end costs a near one no digits. A line within an end's plane is outside; one parallel to the
/// planes and between them is inside everywhere.
[[nodiscard]] inline LineInterval slab_interval(const scene::Solid& solid, const Axis& axis, const Vec3& origin,
                                                const Vec3& direction, std::uint32_t start_part) {
  const double rise = direction.dot(axis.along);
  double below_a = (solid.a - origin).dot(axis.along);
  double below_b = (solid.b - origin).dot(axis.along);
  // The start is known to lie on an end: the distance to the other end is then the length, without a subtraction.
  if (start_part == kCapA) below_a = 0, below_b = axis.length;
  if (start_part == kCapB) below_a = -axis.length, below_b = 0;
  LineInterval slab;
  if (rise == 0) {
    if (!(below_a < 0 && below_b > 0) && start_part != kSide) slab = LineInterval::none();
  } else {
    slab = LineInterval::between({below_a / rise, kCapA, start_part == kCapA},
                                 {below_b / rise, kCapB, start_part == kCapB});
  }
  if (start_part == kSide) slab.hold_origin();
  return slab;
}

}  // namespace isl::render
