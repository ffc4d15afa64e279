// The squared distance q of the three skeletons, relative to the squared radius, from the definition; in long double
// and over intervals. Used by reference_field and reference_ray; must not know kernels, rays or blobs.
//
// All three are one: spheres whose centre c(v) = a + v·e and radius r(v) = r_a + v·Δr run with v from 0 to 1, and
//   q(p) = min over v of |p − c(v)|²/r(v)².
// A point has e = 0 and Δr = 0, a segment Δr = 0. With w = p − a, E = |e|², v̂ = w·e/E and ρ² = |w − v̂e|² the quotient
// is (E(v − v̂)² + ρ²)/r(v)², and its derivative has the sign of (v − v̂)EA − Δr·ρ², where A = r_a + Δr·v̂. So for A > 0
// it falls up to v* = v̂ + Δr·ρ²/(E·A) and rises after; for A ≤ 0 (behind the apex) it falls towards the larger end.
// Clamping v* to [0, 1] is therefore the minimum. (At the tip of a cone with a radius of zero q has no value.) By the
// envelope theorem ∇q = 2(p − c(v*))/r(v*)².
#pragma once

#include "renderer/scene/database.h"
#include "tests/reference/interval.h"

namespace isl::reference {

[[nodiscard]] inline Vector<long double> exactly(const scene::Vec3& v) { return {v.x, v.y, v.z}; }
[[nodiscard]] inline Vector<Interval> interval_of(const scene::Vec3& v) {
  return {Interval(v.x), Interval(v.y), Interval(v.z)};
}

/// Stands for "any size at all" where a bound does not exist; far from overflow even after multiplications.
inline constexpr long double kUnbounded = 1e4000L;

class ReferenceSkeleton {
 public:
  explicit ReferenceSkeleton(const scene::Component& component);

  /// v* of the points in a box, given w = p − a.
  [[nodiscard]] Interval nearest(const Vector<Interval>& w) const;
  /// v* from enclosures of v̂ and ρ².
  [[nodiscard]] Interval nearest(const Interval& foot, const Interval& rho_squared) const;
  /// p − c(v).
  [[nodiscard]] Vector<Interval> offset(const Vector<Interval>& w, const Interval& v) const { return w - axis_ * v; }
  /// v̂ of w. Precondition: has_axis().
  [[nodiscard]] Interval foot(const Vector<Interval>& w) const { return dot(w, axis_) / axis_squared_; }

  /// A sphere about bound_centre() with radius reach(q) holds every point whose q is at most the given one.
  [[nodiscard]] const Vector<long double>& bound_centre() const { return bound_centre_; }
  [[nodiscard]] long double reach(long double q) const;

  [[nodiscard]] const Vector<Interval>& start() const { return start_; }
  [[nodiscard]] const Vector<Interval>& axis() const { return axis_; }
  [[nodiscard]] Interval radius(const Interval& v) const { return radius_start_ + radius_step_ * v; }
  /// distance²/r(v)². Where the radius may be zero, everything from zero up.
  [[nodiscard]] Interval relative(const Interval& distance_squared, const Interval& v) const;
  [[nodiscard]] bool has_axis() const { return has_axis_; }
  /// True where q is convex: it is a squared distance to a convex set over a constant.
  [[nodiscard]] bool has_constant_radius() const { return radius_step_.hi == 0 && radius_step_.lo == 0; }

 private:
  Vector<Interval> start_, axis_;
  Interval axis_squared_, radius_start_, radius_step_;
  Vector<long double> bound_centre_;
  long double half_length_, largest_radius_;
  bool has_axis_;
};

}  // namespace isl::reference
