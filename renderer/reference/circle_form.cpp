// The circle about the centre a and the axis b, of radius R, with the radius r about it. With w = p − a, its part
// h·b along the axis (h = w·b/|b|²) and the rest u, ρ = |u|, the nearest point is a + R·u/ρ:
//   q = ((ρ − R)² + h²|b|²)/r² = (|w|² − 2Rρ + R²)/r²,   ∇q = 2(u(ρ − R)/ρ + h·b)/r².
// On the axis q has a crease and no gradient; u/ρ is any direction there.
//
// Along a line q is a difference of convex functions: dq/dt = 2(w·d − R·ρ′)/r², where w·d is linear. ρ, the length of a
// linear function, is convex: ρ′ = u·d/ρ rises. So both get their ranges from the ends.
#include "renderer/reference/skeleton_forms.h"

#include <algorithm>

namespace isl::ISL_REFERENCE {
namespace {

class CircleForm final : public SkeletonForm {
 public:
  explicit CircleForm(const scene::Component& component)
      : centre_(interval_of(component.a)),
        axis_(interval_of(component.b)),
        ring_radius_(component.radius_b),
        radius_squared_(square(Interval(component.radius_a))),
        radius_(component.radius_a) {}

  [[nodiscard]] SkeletonExtent extent() const override {
    return {{centre_.x.middle(), centre_.y.middle(), centre_.z.middle()}, ring_radius_, radius_};
  }

  [[nodiscard]] RelativeDistance at(const Vector<Interval>& p) const override {
    const Cylindrical c = cylindrical(p);
    const Interval beside = c.rho - Interval(ring_radius_);
    Vector<Interval> across = c.across;
    if (c.rho.lo > 0) {
      across = across * (beside / c.rho);
    } else {
      const Interval any(-ring_radius_, ring_radius_);
      across = across + Vector<Interval>{any, any, any};
    }
    return {relative(c.rho, c.height), (across + axis_ * c.height) * (Interval(2) / radius_squared_)};
  }

  [[nodiscard]] DistanceOnLine over(const Stretch& stretch) const override {
    const Vector<Interval>& d = stretch.line.direction;
    const Cylindrical start = cylindrical(stretch.line.at(stretch.t0)), end = cylindrical(stretch.line.at(stretch.t1));
    const DistanceOnLine rho0{start.rho, rho_slope(start, d)}, rho1{end.rho, rho_slope(end, d)};
    const Interval rho_slopes(rho0.slope.lo, std::max(rho0.slope.lo, rho1.slope.hi));
    const Interval along = hull(dot(start.w, d), dot(end.w, d));
    const Interval slope = Interval(2) * (along - Interval(ring_radius_) * rho_slopes) / radius_squared_;
    const Real least_rho = convex_minimum(stretch.t0, stretch.t1, rho0, rho1);
    const Interval rho(std::max(least_rho, Real(0)), std::max(start.rho.hi, end.rho.hi));
    const Interval plain = relative(rho, hull(start.height, end.height));
    const Interval q =
        common(common(plain, stretch.first.q + slope * stretch.steps()), stretch.last.q - slope * stretch.steps());
    return {{std::max(q.lo, Real(0)), q.hi}, slope};
  }

 private:
  struct Cylindrical {
    Vector<Interval> w, across;  ///< p − a, and u
    Interval rho, height;        ///< ρ, and h in units of the axis
  };

  [[nodiscard]] Cylindrical cylindrical(const Vector<Interval>& p) const {
    const Vector<Interval> w = p - centre_;
    const Interval height = dot(w, axis_) / squared_length(axis_);
    const Vector<Interval> across = w - axis_ * height;
    return {w, across, square_root(squared_length(across)), height};
  }
  [[nodiscard]] Interval relative(const Interval& rho, const Interval& height) const {
    return (square(rho - Interval(ring_radius_)) + square(height) * squared_length(axis_)) / radius_squared_;
  }
  /// ρ′; on the axis, all values that the speed allows.
  [[nodiscard]] static Interval rho_slope(const Cylindrical& c, const Vector<Interval>& d) {
    if (c.rho.lo > 0) return dot(c.across, d) / c.rho;
    const Real speed = square_root(squared_length(d)).hi;
    return {-speed, speed};
  }

  Vector<Interval> centre_, axis_;
  Real ring_radius_;
  Interval radius_squared_;
  Real radius_;
};

}  // namespace

SkeletonFormHandle circle_form(const scene::Component& component) { return std::make_shared<CircleForm>(component); }

}  // namespace isl::ISL_REFERENCE
