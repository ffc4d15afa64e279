// Point, segment and cone have one form: spheres whose centre c(v) = a + v·e and radius r(v) = r_a + v·Δr run with v
// from 0 to 1, and
//   q(p) = min over v of |p − c(v)|²/r(v)².
// A point has e = 0 and Δr = 0, a segment Δr = 0. With w = p − a, E = |e|², v̂ = w·e/E and ρ² = |w − v̂e|² the quotient
// is (E(v − v̂)² + ρ²)/r(v)², and its derivative has the sign of (v − v̂)EA − Δr·ρ², where A = r_a + Δr·v̂. So for A > 0
// it falls up to v* = v̂ + Δr·ρ²/(E·A) and rises after; for A ≤ 0 (behind the apex) it falls towards the larger end.
// Clamping v* to [0, 1] is therefore the minimum. (At the tip of a cone with a radius of zero q has no value.) By the
// envelope theorem ∇q = 2(p − c(v*))/r(v*)².
#include "renderer/reference/skeleton_forms.h"

#include <algorithm>

namespace isl::ISL_REFERENCE {
namespace {

class LimbForm final : public SkeletonForm {
 public:
  explicit LimbForm(const scene::Component& component)
      : start_(interval_of(component.a)), radius_start_(component.radius_a), largest_radius_(component.radius_a) {
    if (component.skeleton != scene::Skeleton::point) axis_ = interval_of(component.b) - start_;
    if (component.skeleton == scene::Skeleton::cone && component.radius_a != component.radius_b) {
      radius_step_ = Interval(component.radius_b) - radius_start_;
      largest_radius_ = std::max(component.radius_a, component.radius_b);
    }
    axis_squared_ = squared_length(axis_);
    has_axis_ = axis_squared_.lo > 0;
  }

  [[nodiscard]] SkeletonExtent extent() const override {
    const Vector<Interval> middle = start_ + axis_ * Interval(0.5L);
    return {{middle.x.middle(), middle.y.middle(), middle.z.middle()}, sqrt(axis_squared_.hi) / 2, largest_radius_};
  }

  [[nodiscard]] RelativeDistance at(const Vector<Interval>& p) const override {
    const Vector<Interval> w = p - start_;
    const Interval v = nearest(w);
    const Interval radius_squared = square(radius(v));
    if (radius_squared.lo <= 0) {
      const Interval any(-kUnbounded, kUnbounded);
      return {{0, kUnbounded}, {any, any, any}};
    }
    const Vector<Interval> offset = w - axis_ * v;
    return {squared_length(offset) / radius_squared, offset * (Interval(2) / radius_squared)};
  }

  [[nodiscard]] DistanceOnLine over(const Stretch& stretch) const override {
    if (radius_step_.lo == 0 && radius_step_.hi == 0) return SkeletonForm::over(stretch);
    // A linear function of t is enclosed by its ends.
    const Vector<Interval>& d = stretch.line.direction;
    const Vector<Interval> w0 = stretch.line.at(stretch.t0) - start_, w1 = stretch.line.at(stretch.t1) - start_;
    Interval v;
    if (has_axis_) {
      const Interval foot0 = foot(w0), foot1 = foot(w1);
      const Vector<Interval> across = hull(w0 - axis_ * foot0, w1 - axis_ * foot1);
      v = nearest(ISL_REFERENCE::hull(foot0, foot1), squared_length(across));
    } else {
      v = nearest(w0);
    }
    const Interval radius_squared = square(radius(v));
    if (radius_squared.lo <= 0) return {{0, kUnbounded}, {-kUnbounded, kUnbounded}};
    const Interval along = ISL_REFERENCE::hull(dot(w0, d), dot(w1, d)) - v * dot(axis_, d);
    const Interval slope = Interval(2) * along / radius_squared;
    const Interval plain = squared_length(hull(w0, w1) - axis_ * v) / radius_squared;
    const Interval q =
        common(common(plain, stretch.first.q + slope * stretch.steps()), stretch.last.q - slope * stretch.steps());
    return {{std::max(q.lo, Real(0)), q.hi}, slope};
  }

 private:
  [[nodiscard]] Interval radius(const Interval& v) const { return radius_start_ + radius_step_ * v; }
  /// v̂. Precondition: has_axis_.
  [[nodiscard]] Interval foot(const Vector<Interval>& w) const { return dot(w, axis_) / axis_squared_; }

  /// v* of the points in a box.
  [[nodiscard]] Interval nearest(const Vector<Interval>& w) const {
    // Without an axis the spheres are concentric, and the larger one is nearer everywhere.
    if (!has_axis_) return radius_step_.lo > 0 ? 1 : 0;
    const Interval along = foot(w);
    return nearest(along, squared_length(w - axis_ * along));
  }
  /// v* from enclosures of v̂ and ρ².
  [[nodiscard]] Interval nearest(const Interval& foot, const Interval& rho_squared) const {
    const Interval apex_distance = radius(foot);
    if (apex_distance.lo > 0) {
      return clamped(foot + radius_step_ * rho_squared / (axis_squared_ * apex_distance), 0, 1);
    }
    if (apex_distance.hi <= 0) return radius_step_.lo > 0 ? 1 : 0;
    // Both sides of the apex: the smaller A is, the nearer v* is to the larger end.
    const Interval least =
        clamped(foot + radius_step_ * rho_squared / (axis_squared_ * Interval(apex_distance.hi)), 0, 1);
    return radius_step_.lo > 0 ? Interval(least.lo, 1) : Interval(0, least.hi);
  }

  Vector<Interval> start_, axis_;
  Interval axis_squared_, radius_start_, radius_step_;
  Real largest_radius_;
  bool has_axis_;
};

}  // namespace

SkeletonFormHandle limb_form(const scene::Component& component) { return std::make_shared<LimbForm>(component); }

}  // namespace isl::ISL_REFERENCE
