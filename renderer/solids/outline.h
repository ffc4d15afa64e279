// Plane outlines of Bézier curves: where lines cross them, what is inside, how far they reach. The solids that are
// swept from them (swept.h) reduce their questions to these.
//
// A line in the plane is the zero set of a linear form g. On a curve, g is a polynomial whose Bernstein coefficients
// are the values of g at the control points, so the curve's crossings are its changes of sign (polynomial_roots.h).
// The sign is followed from curve to curve around a whole contour: what rounding leaves open at a corner is decided by
// the next certain value, every contour is crossed an even number of times, and a line through a corner enters once or
// not at all. Where all control points of a part of the contour are on the side of the present sign, the part is
// skipped; a tree of boxes makes that fast.
#pragma once

#include "renderer/solids/solid.h"

#include <cmath>
#include <span>
#include <vector>

namespace isl::render {

/// g(p) = u (p.u − base.u) + v (p.v − base.v) + constant. The sizes are the sums of the absolute terms that u, v and
/// constant were computed from: they bound what rounding moves g by.
struct LinearForm {
  double u, v, constant = 0;
  double size_u, size_v, size_constant = 0;
  PlanePoint base;

  /// The form that is positive to the left of a line.
  static LinearForm of_line(const PlanePoint& from, const PlanePoint& direction) {
    return {.u = -direction.v,
            .v = direction.u,
            .size_u = std::abs(direction.v),
            .size_v = std::abs(direction.u),
            .base = from};
  }
  [[nodiscard]] double at(const PlanePoint& p) const { return u * (p.u - base.u) + v * (p.v - base.v) + constant; }
  /// The change of the form along a vector.
  [[nodiscard]] double along(const PlanePoint& step) const { return u * step.u + v * step.v; }
  [[nodiscard]] double size_along(const PlanePoint& step) const {
    return size_u * std::abs(step.u) + size_v * std::abs(step.v);
  }
  [[nodiscard]] double size_at(const PlanePoint& p) const {
    return size_u * std::abs(p.u - base.u) + size_v * std::abs(p.v - base.v) + size_constant;
  }
};

/// A place on an outline.
struct OutlinePlace {
  std::uint32_t node = scene::kNone;  ///< that of the curve
  double w = 0;                       ///< the curve's parameter, in [0, 1]
  PlanePoint point;
  PlanePoint tangent;  ///< the curve's derivative
};

/// A place where a form changes its sign.
struct OutlineCrossing {
  PlanePoint point;
  std::uint32_t node = scene::kNone;  ///< that of the curve, if the outline is a prepared one
  int turn = 0;                       ///< +1 if the contour passes from negative to positive values of the form
  bool is_start = false;              ///< the known zero
  double t = 0;                       ///< for the caller
};

/// A rectangle of the outline's plane; at first the whole.
struct PlaneWindow {
  PlanePoint low{-HUGE_VAL, -HUGE_VAL}, high{HUGE_VAL, HUGE_VAL};
};

/// Finds all of them, in the order of the contours. A form that is known to be zero at `start` has a crossing or a
/// touch there, and its other zeros on that curve are those of the quotient: near ones are told from it for certain.
/// Contours that are nowhere in the window are left out as a whole: they surround none of its points.
void find_crossings(const PreparedOutline& outline, const LinearForm& form, std::vector<OutlineCrossing>& crossings,
                    const PlaneWindow& window = {}, const OutlinePlace* start = nullptr);
void find_crossings(const scene::Outline& outline, const LinearForm& form, std::vector<OutlineCrossing>& crossings);

/// Follows how often contours wind around the points of a line from one crossing to the next.
class OutlineFill {
 public:
  explicit OutlineFill(const scene::Outline& outline) : by_winding_(outline.fills_by_winding) {}
  void pass(const OutlineCrossing& crossing) { winding_ += by_winding_ ? crossing.turn : 1; }
  [[nodiscard]] bool is_inside() const { return by_winding_ ? winding_ != 0 : winding_ % 2 != 0; }

 private:
  bool by_winding_;
  int winding_ = 0;
};

/// True if a point of the plane is inside.
[[nodiscard]] bool contains(const PreparedOutline& outline, const PlanePoint& point);
[[nodiscard]] bool contains(const scene::Outline& outline, const PlanePoint& point);

/// The control points of the curve of a node.
[[nodiscard]] std::span<const PlanePoint> curve_of(const scene::Outline& outline, const OutlineNode& node);

/// The place on a node's curve nearest to a point; fast for points on the curve.
[[nodiscard]] OutlinePlace nearest_on(const PreparedOutline& outline, std::uint32_t node, const PlanePoint& point);

/// The greatest direction · p over the outline, up to rounding.
[[nodiscard]] double reach_of(const scene::Outline& outline, const PlanePoint& direction);

}  // namespace isl::render
