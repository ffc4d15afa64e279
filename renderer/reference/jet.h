// A function of t on a stretch of a line: enclosures of its value, its slope and its bend (the first and the second
// derivative) that hold everywhere on the stretch, which may be one place. Arithmetic on jets is automatic
// differentiation: a formula is written once, and its derivatives and bounds follow.
//
// The enclosure of a bend that jumps holds its values on both sides. Then the mean value theorem still holds for the
// slope, which is continuous.
#pragma once

#include "renderer/reference/interval.h"

namespace isl::ISL_REFERENCE {

struct Jet {
  Interval value, slope, bend;
};

[[nodiscard]] inline Jet operator+(const Jet& a, const Jet& b) {
  return {a.value + b.value, a.slope + b.slope, a.bend + b.bend};
}
inline Jet& operator+=(Jet& a, const Jet& b) {
  a.value += b.value;
  a.slope += b.slope;
  a.bend += b.bend;
  return a;
}
[[nodiscard]] inline Jet operator-(const Jet& a) { return {-a.value, -a.slope, -a.bend}; }
[[nodiscard]] inline Jet operator-(const Jet& a, const Jet& b) {
  return {a.value - b.value, a.slope - b.slope, a.bend - b.bend};
}
[[nodiscard]] inline Jet operator*(const Jet& a, const Jet& b) {
  return {a.value * b.value, a.value * b.slope + a.slope * b.value,
          a.value * b.bend + Interval(2) * a.slope * b.slope + a.bend * b.value};
}
// With constants.
[[nodiscard]] inline Jet operator+(const Jet& a, const Interval& c) { return {a.value + c, a.slope, a.bend}; }
[[nodiscard]] inline Jet operator-(const Jet& a, const Interval& c) { return {a.value - c, a.slope, a.bend}; }
[[nodiscard]] inline Jet operator-(const Interval& c, const Jet& a) { return {c - a.value, -a.slope, -a.bend}; }
[[nodiscard]] inline Jet operator*(const Jet& a, const Interval& c) { return {a.value * c, a.slope * c, a.bend * c}; }

/// f(a), from enclosures of f, f′ and f″ over the values of a.
[[nodiscard]] inline Jet chain(const Interval& f, const Interval& df, const Interval& ddf, const Jet& a) {
  return {f, df * a.slope, ddf * square(a.slope) + df * a.bend};
}

[[nodiscard]] inline Jet square(const Jet& a) {
  const Interval twice = Interval(2) * a.value;
  return {square(a.value), twice * a.slope, Interval(2) * square(a.slope) + twice * a.bend};
}
/// Precondition: the values do not hold 0.
[[nodiscard]] inline Jet inverse(const Jet& a) {
  const Interval f = Interval(1) / a.value, f2 = square(f);
  return chain(f, -f2, Interval(2) * f2 * f, a);
}
/// Precondition: the values are positive.
[[nodiscard]] inline Jet square_root(const Jet& a) {
  const Interval root = square_root(a.value), df = Interval(0.5L) / root;
  return chain(root, df, -(df / (Interval(2) * a.value)), a);
}
/// The square of the positive part.
[[nodiscard]] inline Jet positive_square(const Jet& a) {
  if (a.value.hi() <= 0) return {};
  const Interval p = positive_part(a.value);
  return chain(square(p), Interval(2) * p, Interval(2) * step(a.value), a);
}

/// Holds both.
[[nodiscard]] inline Jet hull(const Jet& a, const Jet& b) {
  return {hull(a.value, b.value), hull(a.slope, b.slope), hull(a.bend, b.bend)};
}

/// Holds sx + bx²/2 for |x| ≤ reach, |s| ≤ slope and every b among the bends.
[[nodiscard]] inline Interval parabola(Size slope, const Interval& bend, Size reach) {
  // It falls to its vertex or, if that is out of reach, to an end; upside down it falls as far as it rises.
  const auto depth = [&](Real b_or_less) {
    const auto b = static_cast<Size>(b_or_less);
    return (slope < b * reach ? slope * slope / (2 * b) : (slope - b * reach / 2) * reach) * kStretch;
  };
  return {-depth(bend.lo()), depth(-bend.hi())};
}

/// A jet over a stretch, made narrower by the same function's jet at the stretch's middle, from which nothing on the
/// stretch is farther away than `reach`: Taylor's formula with the remainder of the first and of the second order.
[[nodiscard]] inline Jet sharpened(const Jet& over, const Jet& middle, Size reach) {
  const Interval away = Interval::around(0, reach);
  Jet result = over;
  result.slope = common(over.slope, middle.slope + over.bend * away);
  const Interval by_slope = middle.value + result.slope * away;
  const Interval by_bend = middle.value + parabola(middle.slope.magnitude(), over.bend, reach);
  result.value = common(common(over.value, by_slope), by_bend);
  return result;
}

/// A jet over a stretch, made narrower by the same function's jets at its ends: where it is convex, its slope rises
/// from one to the other and its values are not above theirs; where it is monotone, its values are between theirs.
[[nodiscard]] inline Jet between(const Jet& over, const Jet& first, const Jet& last) {
  Jet result = over;
  const bool is_convex = over.bend.lo() >= 0;
  if (is_convex) result.slope = common(over.slope, hull(first.slope, last.slope));
  const Interval ends = hull(first.value, last.value);
  if (result.slope.lo() >= 0 || result.slope.hi() <= 0) {
    result.value = common(over.value, ends);
  } else if (is_convex && over.value.hi() > ends.hi()) {
    result.value = Interval(std::min(over.value.lo(), ends.hi()), ends.hi());
  }
  return result;
}

/// A straight line: its points are origin + t·direction.
struct Line {
  Vector<Interval> origin, direction;

  /// The point at t, or at all t of an interval, as functions of t.
  [[nodiscard]] Vector<Jet> at(const Interval& t) const {
    const auto coordinate = [&](const Interval& o, const Interval& d) { return Jet{o + d * t, d, 0}; };
    return {coordinate(origin.x, direction.x), coordinate(origin.y, direction.y), coordinate(origin.z, direction.z)};
  }
};

}  // namespace isl::ISL_REFERENCE
