// The intersection of a line with a sphere about the origin, and, for components perpendicular to an axis, with a
// cylinder.
//
// |o + t d|² = r² is  dd t² + 2 b t + c = 0  with dd = d·d, b = o·d, c = |o|² − r². The textbook discriminant b² − dd c
// subtracts numbers of the size of (|o| |d|)² and loses everything when the origin is far. Instead, with the foot of
// the perpendicular p = o − (b/dd) d, the discriminant is dd (r² − |p|²) = dd (r − |p|)(r + |p|): relative to the
// radius (Haines et al., Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems 7). The root that b and
// the square root add up to is q/dd, q = −(b + sign(b)√D); the other is c/q, from Vieta, without cancellation; and c =
// (|o| − r)(|o| + r).
#pragma once

#include "renderer/solids/line_interval.h"

#include <cmath>

namespace isl::render {

/// The interval with |offset + t·direction| < radius. It is empty for tangency and for a zero direction, except that a
/// zero direction inside is inside everywhere (a line along a cylinder's axis). `on_surface`: t = 0 is exactly a root;
/// the other root is −2b/dd.
[[nodiscard]] inline LineInterval within_radius(const Vec3& offset, const Vec3& direction, double radius,
                                                bool on_surface) {
  const double dd = direction.dot(direction);
  const double b = offset.dot(direction);
  if (dd == 0) return offset.length() < radius && !on_surface ? LineInterval{} : LineInterval::none();
  if (on_surface) {
    return LineInterval::between({0, kSide, true}, {-2 * b / dd, kSide, false});
  }
  const double distance = (offset - direction * (b / dd)).length();
  const double discriminant = dd * (radius - distance) * (radius + distance);
  if (!(discriminant > 0)) return LineInterval::none();
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  const double start = offset.length();
  const double c = (start - radius) * (start + radius);
  return LineInterval::between({q / dd, kSide}, {c / q, kSide});
}

}  // namespace isl::render
