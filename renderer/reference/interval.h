// Intervals and vectors of the reference: numbers that carry their own error, so that "F is positive
// here" is a proof. This is a leaf of renderer/reference; it must not know fields, and shares nothing with the
// product's bounds.
//
// There is no directed rounding. Every operation computes its ends to nearest, which is off by at most kRoundoff of the
// result, and then moves them outward by kRounding of it. Denormals do not occur: the exponents of both types of
// numbers (real.h) reach 10^-4932.
#pragma once

#include "renderer/reference/real.h"

#include <algorithm>

namespace isl::ISL_REFERENCE {

/// A closed interval lo ≤ hi that holds the exact value. A plain number converts to the interval that holds just it.
struct Interval {
  Real lo = 0, hi = 0;

  constexpr Interval() = default;
  constexpr Interval(Real value) : lo(value), hi(value) {}  // NOLINT: a number is an interval
  constexpr Interval(Real low, Real high) : lo(low), hi(high) {}

  [[nodiscard]] bool contains(Real x) const { return lo <= x && x <= hi; }
  [[nodiscard]] Real width() const { return hi - lo; }
  [[nodiscard]] Real middle() const { return lo + (hi - lo) / 2; }
  /// The largest absolute value.
  [[nodiscard]] Real magnitude() const { return std::max(abs(lo), abs(hi)); }
  /// The smallest absolute value.
  [[nodiscard]] Real mignitude() const { return contains(0) ? 0 : std::min(abs(lo), abs(hi)); }
  /// +1 or −1 if every member has that sign, else 0.
  [[nodiscard]] int sign() const { return lo > 0 ? 1 : hi < 0 ? -1 : 0; }
};

/// Ends moved outward by `relative` of themselves.
[[nodiscard]] inline Interval widened(Real lo, Real hi, Real relative = kRounding) {
  return {lo - abs(lo) * relative, hi + abs(hi) * relative};
}

[[nodiscard]] inline Interval operator+(const Interval& a, const Interval& b) {
  return widened(a.lo + b.lo, a.hi + b.hi);
}
[[nodiscard]] inline Interval operator-(const Interval& a, const Interval& b) {
  return widened(a.lo - b.hi, a.hi - b.lo);
}
[[nodiscard]] inline Interval operator-(const Interval& a) { return {-a.hi, -a.lo}; }

[[nodiscard]] inline Interval operator*(const Interval& a, const Interval& b) {
  const Real p = a.lo * b.lo, q = a.lo * b.hi, r = a.hi * b.lo, s = a.hi * b.hi;
  return widened(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
}

/// Precondition: b is positive throughout.
[[nodiscard]] inline Interval operator/(const Interval& a, const Interval& b) {
  return a * widened(1 / b.hi, 1 / b.lo);
}

/// a·a, never negative.
[[nodiscard]] inline Interval square(const Interval& a) {
  const Real near = a.mignitude(), far = a.magnitude();
  return widened(near * near, far * far);
}

/// √a. Precondition: a ≥ 0. (Square roots are correctly rounded.)
[[nodiscard]] inline Interval square_root(const Interval& a) { return widened(sqrt(a.lo), sqrt(a.hi)); }

[[nodiscard]] inline Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}

/// The intersection of two enclosures of one value. If rounding left none, `a`.
[[nodiscard]] inline Interval common(const Interval& a, const Interval& b) {
  const Interval both{std::max(a.lo, b.lo), std::min(a.hi, b.hi)};
  return both.lo <= both.hi ? both : a;
}

[[nodiscard]] inline Interval clamped(const Interval& a, Real lo, Real hi) {
  return {std::clamp(a.lo, lo, hi), std::clamp(a.hi, lo, hi)};
}

/// Three numbers or three intervals.
template <class Number>
struct Vector {
  Number x{}, y{}, z{};
};

template <class Number>
[[nodiscard]] Vector<Number> operator+(const Vector<Number>& a, const Vector<Number>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Number>
[[nodiscard]] Vector<Number> operator-(const Vector<Number>& a, const Vector<Number>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Number>
[[nodiscard]] Vector<Number> operator*(const Vector<Number>& a, const Number& s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class Number>
[[nodiscard]] Number dot(const Vector<Number>& a, const Vector<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Number>
[[nodiscard]] Vector<Number> cross(const Vector<Number>& a, const Vector<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline Real squared_length(const Vector<Real>& a) { return dot(a, a); }
[[nodiscard]] inline Interval squared_length(const Vector<Interval>& a) {
  return square(a.x) + square(a.y) + square(a.z);
}

}  // namespace isl::ISL_REFERENCE
