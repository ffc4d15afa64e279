// Splines, made from points in any order and evaluated at a parameter. The rules are POV-Ray's, from its manual and
// from probes of the program:
//
// - linear: straight between neighbours. quadratic: the parabola through a segment's two ends and the point before them
//   (after them in the first segment). natural: the cubic spline of continuous curvature whose curvature at both ends
//   is zero. These hold their first and last value outside their range.
// - cubic: between two points the cubic with their values and slopes, where a point's slope is the mean of the slopes
//   of the two chords that meet there. The outermost points only shape the curve: it runs from the second to the last
//   but one point, and holds their values outside.
#pragma once

#include "renderer/scene/spline.h"

#include <array>

namespace isl::values {

/// The spline's terms at `parameter`, evaluated as a spline of `kind`; terms beyond spline.term_count are zero. NaN
/// gives the last point.
[[nodiscard]] std::array<double, 5> evaluate(const scene::Spline& spline, scene::SplineKind kind,
                                             double parameter) noexcept;

/// Inserts a point in order. If the parameter is taken, the new point replaces the old one, except at the end of the
/// spline, where it is dropped (POV-Ray's behaviour).
void insert(scene::Spline& spline, double parameter, const std::array<double, 5>& value);

/// Computes the second derivatives that evaluation needs. Call it after the last insert().
void finish(scene::Spline& spline);

}  // namespace isl::values
