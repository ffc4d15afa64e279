// Segment and round cone: the skeletons with an axis. In the half-plane through the axis, x along it from end a and ρ
// from it, a sphere of radius r(u) = r₀ + ku stands at every u in [0, L]; the field's argument is the nearest of them,
//
//   q(x, ρ) = min over u of ((x − u)² + ρ²) / r(u)².
//
// With w = r(x) = r₀ + kx and s = 1/r(u): (x − u)/r(u) = (ws − 1)/k, so that k²·(…) = (ws − 1)² + k²ρ²s², a convex
// quadratic in s with its minimum at s* = w/(w² + k²ρ²). Hence u* = x + kρ²/w and q = ρ²/(w² + k²ρ²) where that lies in
// [0, L]; elsewhere the nearer end in s (for w ≤ 0, beyond the apex, the thick end). q is C¹ across the borders, since
// u only stops at an end. A segment is the cone with k = 0. The sets q ≤ c are convex (hulls of two spheres), so q is
// quasi-convex, with its least value on any line parallel to the axis at the point nearest to the thick end.
#pragma once

#include "renderer/fields/skeletons/skeleton.h"

namespace isl::render {

struct Limb {
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
    const Vec3 half = box.size() * 0.5;
    const Vec3 centre = box.center() - a;
    const double x = centre.dot(axis);
    const double half_x = std::abs(axis.x) * half.x + std::abs(axis.y) * half.y + std::abs(axis.z) * half.z;
    const double rho = (centre - axis * x).length();
    double least_axial2 = half_x * half_x;
    for (const Vec3& diagonal :
         {Vec3(-half.x, half.y, half.z), Vec3(half.x, -half.y, half.z), Vec3(half.x, half.y, -half.z)}) {
      const double axial = diagonal.dot(axis);
      least_axial2 = std::min(least_axial2, axial * axial);
    }
    const double half_rho = std::sqrt(std::max(half.length2() - least_axial2, 0.0));
    const double rho_low = std::max(rho - half_rho, 0.0), rho_high = rho + half_rho;
    const double nearest_x = std::clamp(thick_end(), x - half_x, x + half_x);
    return {q(nearest_x, rho_low * rho_low),
            std::max(q(x - half_x, rho_high * rho_high), q(x + half_x, rho_high * rho_high))};
  }

  [[nodiscard]] double thickest() const { return std::max(radius, radius_at(length)); }
  [[nodiscard]] std::array<Reach, 2> reach(const Vec3& n) const {
    const double at_a = n.dot(a);
    return {Reach{at_a, radius}, Reach{at_a + n.dot(axis) * length, radius_at(length)}};
  }

  /// Of a segment: the end spheres, and between the end planes the distance to the axis. A cone has lanes of its own.
  template <class Emit>
  void along(const Vec3& origin, const Vec3& direction, const Emit& emit) const {
    const Vec3 from_a = origin - a;
    const double x = from_a.dot(axis), dx = direction.dot(axis);
    const double inverse_radius2 = 1 / (radius * radius);
    Breaks<2> breaks;
    breaks.add(x, dx, 0);
    breaks.add(x, dx, length);
    breaks.for_each([&](double begin, double end, double inside) {
      const double place = x + inside * dx;
      if (place < 0) return emit(sphere_piece(a, inverse_radius2, origin, direction, begin, end));
      if (place > length) return emit(sphere_piece(a + axis * length, inverse_radius2, origin, direction, begin, end));
      const Vec3 from = from_a - axis * x, by = direction - axis * dx;
      const double dd = by.length2();
      const double middle = dd > 0 ? -from.dot(by) / dd : 0;
      emit(QuadraticPiece{inverse_radius2 * (from + by * middle).length2(), inverse_radius2 * dd, middle, begin, end});
    });
  }
};

}  // namespace isl::render
