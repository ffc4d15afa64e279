// Intervals and vectors of the reference: numbers in long double that carry their own error, so that "F is positive
// here" is a proof. This is a leaf of renderer/reference; it must not know fields, and shares nothing with the
// product's bounds.
//
// There is no directed rounding. Every operation computes its ends to nearest, which is off by at most 2^-64 of the
// result, and then moves them outward by 2^-62 of it. Denormals do not occur: a long double's exponent reaches
// 10^-4932.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace isl::reference {

static_assert(std::numeric_limits<long double>::digits >= 64, "the reference needs an 80-bit long double");

/// A closed interval lo ≤ hi that holds the exact value. A plain number converts to the interval that holds just it.
struct Interval {
  long double lo = 0, hi = 0;

  constexpr Interval() = default;
  constexpr Interval(long double value) : lo(value), hi(value) {}  // NOLINT: a number is an interval
  constexpr Interval(long double low, long double high) : lo(low), hi(high) {}

  [[nodiscard]] bool contains(long double x) const { return lo <= x && x <= hi; }
  [[nodiscard]] long double width() const { return hi - lo; }
  [[nodiscard]] long double middle() const { return lo + (hi - lo) / 2; }
  /// The largest absolute value.
  [[nodiscard]] long double magnitude() const { return std::max(std::abs(lo), std::abs(hi)); }
  /// The smallest absolute value.
  [[nodiscard]] long double mignitude() const { return contains(0) ? 0 : std::min(std::abs(lo), std::abs(hi)); }
  /// +1 or −1 if every member has that sign, else 0.
  [[nodiscard]] int sign() const { return lo > 0 ? 1 : hi < 0 ? -1 : 0; }
};

/// Ends moved outward by `relative` of themselves.
[[nodiscard]] inline Interval widened(long double lo, long double hi, long double relative = 0x1p-62L) {
  return {lo - std::abs(lo) * relative, hi + std::abs(hi) * relative};
}

[[nodiscard]] inline Interval operator+(const Interval& a, const Interval& b) {
  return widened(a.lo + b.lo, a.hi + b.hi);
}
[[nodiscard]] inline Interval operator-(const Interval& a, const Interval& b) {
  return widened(a.lo - b.hi, a.hi - b.lo);
}
[[nodiscard]] inline Interval operator-(const Interval& a) { return {-a.hi, -a.lo}; }

[[nodiscard]] inline Interval operator*(const Interval& a, const Interval& b) {
  const long double p = a.lo * b.lo, q = a.lo * b.hi, r = a.hi * b.lo, s = a.hi * b.hi;
  return widened(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
}

/// Precondition: b is positive throughout.
[[nodiscard]] inline Interval operator/(const Interval& a, const Interval& b) {
  return a * widened(1 / b.hi, 1 / b.lo);
}

/// a·a, never negative.
[[nodiscard]] inline Interval square(const Interval& a) {
  const long double near = a.mignitude(), far = a.magnitude();
  return widened(near * near, far * far);
}

/// √a. Precondition: a ≥ 0. (A long double's square root is correctly rounded.)
[[nodiscard]] inline Interval square_root(const Interval& a) { return widened(std::sqrt(a.lo), std::sqrt(a.hi)); }

[[nodiscard]] inline Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}

/// The intersection of two enclosures of one value. If rounding left none, `a`.
[[nodiscard]] inline Interval common(const Interval& a, const Interval& b) {
  const Interval both{std::max(a.lo, b.lo), std::min(a.hi, b.hi)};
  return both.lo <= both.hi ? both : a;
}

[[nodiscard]] inline Interval clamped(const Interval& a, long double lo, long double hi) {
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
[[nodiscard]] inline long double squared_length(const Vector<long double>& a) { return dot(a, a); }
[[nodiscard]] inline Interval squared_length(const Vector<Interval>& a) {
  return square(a.x) + square(a.y) + square(a.z);
}

}  // namespace isl::reference
