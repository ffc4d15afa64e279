// Numbers that carry their own error, so that "F is positive here" is a proof: an interval is kept as its middle and
// its radius. This is a leaf of renderer/reference.
//
// There is no directed rounding. The middle of a result is off by at most kRoundoff of itself, which becomes part of
// the radius. The radius is computed in long double with some ten operations at most, and stretched by kStretch, which
// is more than their rounding. Denormals do not occur: the exponents of both types reach 10^-4932.
#pragma once

#include "renderer/reference/real.h"

#include <algorithm>

namespace isl::ISL_REFERENCE {

inline constexpr Size kStretch = 1 + 0x1p-58L;

/// Stands for "any size at all" where there is no bound. Its fourth power does not overflow.
inline constexpr Size kUnbounded = 1e1200L;

/// Holds the exact value. A plain number converts to the interval that holds just it.
class Interval {
 public:
  constexpr Interval() = default;
  constexpr Interval(Real value) : middle_(value) {}  // NOLINT: a number is an interval
  /// [low, high].
  Interval(Real low, Real high) : middle_(low / 2 + high / 2) {
    radius_ = static_cast<Size>(std::max(high - middle_, middle_ - low)) * kStretch;
  }
  [[nodiscard]] static constexpr Interval around(Real middle, Size radius) {
    Interval result(middle);
    result.radius_ = radius;
    return result;
  }
  /// The result of one rounded operation whose exact value is off by `radius` besides.
  [[nodiscard]] static Interval rounded(Real middle, Size radius, Size roundings = 1) {
    return around(middle, (radius + size(middle) * (roundings * kRoundoff)) * kStretch);
  }
  /// The same, to this interval.
  void assign(Real middle, Size radius) {
    middle_ = middle;
    radius_ = (radius + size(middle) * kRoundoff) * kStretch;
  }

  [[nodiscard]] Real middle() const { return middle_; }
  [[nodiscard]] Size radius() const { return radius_; }
  // Ends are rounded outwards. The middle's rounding counts only where a radius has been subtracted from it.
  [[nodiscard]] Real lo() const { return radius_ == 0 ? middle_ : middle_ - outer_radius(); }
  [[nodiscard]] Real hi() const { return radius_ == 0 ? middle_ : middle_ + outer_radius(); }
  [[nodiscard]] Real width() const { return 2 * static_cast<Real>(radius_); }
  /// The largest and the smallest absolute value, the one rounded up and the other down.
  [[nodiscard]] Size magnitude() const { return (size(middle_) + radius_) * kStretch; }
  [[nodiscard]] Size mignitude() const { return std::max((size(middle_) / kStretch - radius_) / kStretch, 0.0L); }
  [[nodiscard]] bool contains(Real x) const { return lo() <= x && x <= hi(); }
  /// +1 or −1 if every member has that sign, else 0.
  [[nodiscard]] int sign() const { return middle_ > radius_ ? 1 : middle_ < -radius_ ? -1 : 0; }

  [[nodiscard]] static Size size(Real x) { return static_cast<Size>(abs(x)); }

 private:
  [[nodiscard]] Real outer_radius() const { return (radius_ + size(middle_) * kRoundoff) * kStretch; }

  Real middle_ = 0;
  Size radius_ = 0;
};

[[nodiscard]] inline Interval operator+(const Interval& a, const Interval& b) {
  return Interval::rounded(a.middle() + b.middle(), a.radius() + b.radius());
}
/// In place: a copy of what has just been stored waits for the store.
inline Interval& operator+=(Interval& a, const Interval& b) {
  a.assign(a.middle() + b.middle(), a.radius() + b.radius());
  return a;
}
[[nodiscard]] inline Interval operator-(const Interval& a) { return Interval::around(-a.middle(), a.radius()); }
[[nodiscard]] inline Interval operator-(const Interval& a, const Interval& b) { return a + -b; }

[[nodiscard]] inline Interval operator*(const Interval& a, const Interval& b) {
  const Size x = Interval::size(a.middle()), y = Interval::size(b.middle());
  return Interval::rounded(a.middle() * b.middle(), x * b.radius() + (y + b.radius()) * a.radius());
}

/// True if first-order formulas lose little: the radius is small beside the middle.
[[nodiscard]] inline bool is_narrow(const Interval& a) { return a.radius() <= Interval::size(a.middle()) * 0x1p-10L; }

/// f of an interval on which f rises, for f with an error of at most `roundings` units of 2⁻⁶⁴ or 2⁻¹¹³.
template <class Function>
[[nodiscard]] Interval rising(const Function& f, const Interval& x, Size roundings) {
  const auto end = [&](Real at) { return Interval::rounded(f(at), 0, roundings); };
  return x.radius() == 0 ? end(x.middle()) : Interval(end(x.lo()).lo(), end(x.hi()).hi());
}
/// glibc's exponentials and logarithms are correct to a few units in the last place, two roundings each; this allows
/// eight.
inline constexpr Size kLibrary = 16;

/// Precondition: b does not hold 0.
[[nodiscard]] inline Interval operator/(const Interval& a, const Interval& b) {
  const Real inverse = 1 / b.middle();
  if (b.radius() == 0) return Interval::rounded(a.middle() / b.middle(), a.radius() * Interval::size(inverse), 2);
  if (!is_narrow(b)) return a * Interval(Interval::rounded(1 / b.hi(), 0).lo(), Interval::rounded(1 / b.lo(), 0).hi());
  return a * Interval::rounded(inverse, Interval::size(inverse) * (b.radius() / b.mignitude()));
}

/// a·a, never negative.
[[nodiscard]] inline Interval square(const Interval& a) {
  if (is_narrow(a)) {
    const Size twice = 2 * Interval::size(a.middle()) + a.radius();
    return Interval::rounded(a.middle() * a.middle(), twice * a.radius());
  }
  const Size near = a.mignitude(), far = a.magnitude();
  return Interval(near * near / kStretch, far * far * kStretch);
}

/// √a. Precondition: a is not below 0; what rounding has put there is left out. (Square roots are correctly rounded.)
[[nodiscard]] inline Interval square_root(const Interval& a) {
  const Real low = std::max(a.lo(), Real(0));
  if (!is_narrow(a)) return Interval(Interval::rounded(sqrt(low), 0).lo(), Interval::rounded(sqrt(a.hi()), 0).hi());
  const Real root = sqrt(a.middle());
  return Interval::rounded(root, root > 0 ? a.radius() / Interval::size(root) : 0);
}

[[nodiscard]] inline Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.lo(), b.lo()), std::max(a.hi(), b.hi())};
}
/// The intersection of two enclosures of one value; of two that hold each other, the inner one as it is.
[[nodiscard]] inline Interval common(const Interval& a, const Interval& b) {
  const Real a_low = a.lo(), a_high = a.hi(), b_low = b.lo(), b_high = b.hi();
  if (a_low >= b_low && a_high <= b_high) return a;
  const Real low = std::max(a_low, b_low), high = std::min(a_high, b_high);
  return low > high || (b_low >= a_low && b_high <= a_high) ? b : Interval(low, high);
}
/// The part that is not negative; 0 if there is none.
[[nodiscard]] inline Interval positive_part(const Interval& a) {
  const Real low = a.lo(), high = a.hi();
  return low >= 0 ? a : high <= 0 ? Interval(0) : Interval(Real(0), high);
}
/// How steep the positive part is: 1, 0, or anything between.
[[nodiscard]] inline Interval step(const Interval& a) {
  return a.lo() >= 0 ? Interval(1) : a.hi() <= 0 ? Interval(0) : Interval::around(0.5L, 0.5L);
}

[[nodiscard]] inline Real square(Real x) { return x * x; }

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
template <class Number, class Factor>
[[nodiscard]] Vector<Number> operator*(const Vector<Number>& a, const Factor& s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class A, class B>
[[nodiscard]] auto dot(const Vector<A>& a, const Vector<B>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Number>
[[nodiscard]] Vector<Number> cross(const Vector<Number>& a, const Vector<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Number>
[[nodiscard]] Number squared_length(const Vector<Number>& a) {
  return square(a.x) + square(a.y) + square(a.z);
}
}  // namespace isl::ISL_REFERENCE
