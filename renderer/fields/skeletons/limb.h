// Segment and round cone: the skeletons with an axis. In the half-plane through the axis, x along it from end a and ρ from
// it, a sphere of radius r(u) = r₀ + ku stands at every u in [0, L]; the field's argument is the nearest of them,
//
//   q(x, ρ) = min over u of ((x − u)² + ρ²) / r(u)².
//
// With w = r(x) = r₀ + kx and s = 1/r(u): (x − u)/r(u) = (ws − 1)/k, so that k²·(…) = (ws − 1)² + k²ρ²s², a convex quadratic in s
// with its minimum at s* = w/(w² + k²ρ²). Hence u* = x + kρ²/w and q = ρ²/(w² + k²ρ²) where that lies in [0, L]; elsewhere the
// nearer end in s (for w ≤ 0, beyond the apex, the thick end). q is C¹ across the borders, since u only stops at an end.
// A segment is the cone with k = 0. The sets q ≤ c are convex (hulls of two spheres), so q is quasi-convex, with its least
// value on any line parallel to the axis at the point nearest to the thick end.
#pragma once

#include "renderer/scene/transform.h"

#include <algorithm>
#include <cmath>

namespace isl::render {

using scene::Vec3;

struct Limb {
  Vec3 a;            ///< where u = 0
  Vec3 axis;         ///< unit
  double length;     ///< L > 0
  double radius;     ///< r₀ ≥ 0
  double slope;      ///< k

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
};

}  // namespace isl::render
