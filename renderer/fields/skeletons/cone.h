// The round cone. In the half-plane through its axis, x along it from end a and ρ from it, a sphere of radius r(u) = r₀
// + ku stands at every u in [0, L]; the field's argument is the nearest of them,
//
//   q(x, ρ) = min over u of ((x − u)² + ρ²) / r(u)².
//
// With w = r(x) = r₀ + kx and s = 1/r(u): (x − u)/r(u) = (ws − 1)/k, so that k²·(…) = (ws − 1)² + k²ρ²s², a convex
// quadratic in s with its minimum at s* = w/(w² + k²ρ²). Hence u* = x + kρ²/w and q = ρ²/(w² + k²ρ²) where that lies in
// [0, L]; elsewhere the nearer end in s (for w ≤ 0, beyond the apex, the thick end). q is C¹ across the borders, since
// u only stops at an end. The sets q ≤ c are convex (hulls of two spheres), so q is quasi-convex, with its least value
// on any line parallel to the axis at the point nearest to the thick end. Along a ray q is no polynomial;
// cone_lanes-inl.h has its lanes.
#pragma once

#include "renderer/fields/skeletons/skeleton.h"

namespace isl::render {

struct Cone {
  Cone(const scene::Blob&, const scene::Component& c) : a(c.a), length((c.b - c.a).length()), radius(c.radius_a) {
    axis = (c.b - c.a) / length;
    slope = (c.radius_b - c.radius_a) / length;
  }

  Vec3 a;         ///< where u = 0
  Vec3 axis;      ///< unit
  double length;  ///< L > 0
  double radius;  ///< r₀ ≥ 0
  double slope;   ///< k

  [[nodiscard]] double radius_at(double u) const { return std::max(radius + slope * u, 0.0); }
  [[nodiscard]] double thick_end() const { return slope > 0 ? length : 0; }

  /// u of the sphere that is nearest to (x, ρ) in the measure of q.
  [[nodiscard]] double nearest(double x, double rho2) const noexcept {
    const double w = radius + slope * x;
    if (!(w > 0)) return thick_end();
    return std::clamp(x + slope * rho2 / w, 0.0, length);
  }

  [[nodiscard]] double q(double x, double rho2) const noexcept {
    const double u = nearest(x, rho2);
    const double r = radius_at(u);
    return ((x - u) * (x - u) + rho2) / (r * r);
  }

  [[nodiscard]] Foot nearest(const Vec3& p) const {
    const Vec3 from_a = p - a;
    const double x = from_a.dot(axis);
    const double u = nearest(x, (from_a - axis * x).length2());
    const double r = radius_at(u);
    return {from_a - axis * u, 1 / (r * r)};
  }

  /// Through the rectangle in (x, ρ) that holds the box.
  [[nodiscard]] QRange q_over(const Box& box) const {
    const AxialRange range(box, a, axis);
    const double nearest_x = std::clamp(thick_end(), range.x_low, range.x_high);
    const double rho2_low = range.rho_low * range.rho_low, rho2_high = range.rho_high * range.rho_high;
    return {q(nearest_x, rho2_low), std::max(q(range.x_low, rho2_high), q(range.x_high, rho2_high))};
  }

  /// From a to b, that of the nearest sphere; around from AcrossAxis' x.
  [[nodiscard]] Coordinates coordinates(const Vec3& p, const scene::Turn& turn) const {
    const Vec3 from_a = p - a;
    const double x = from_a.dot(axis);
    const AcrossAxis across(turn.back(axis));
    return {nearest(x, (from_a - axis * x).length2()) / length, across.share_of_turn(turn.back(from_a))};
  }

  [[nodiscard]] double thickest() const { return std::max(radius, radius_at(length)); }
  [[nodiscard]] std::array<Reach, 2> reach(const Vec3& n) const {
    const double at_a = n.dot(a);
    return {Reach{at_a, radius}, Reach{at_a + n.dot(axis) * length, radius_at(length)}};
  }
};

}  // namespace isl::render
