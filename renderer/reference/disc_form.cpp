// The disc about the centre a, across the axis b, of radius R, with the radius r about it. With w = p − a, its part h·b
// along the axis (h = w·b/|b|²) and the rest u, ρ = |u|, the nearest point is a + u where ρ ≤ R, else a + R·u/ρ. So
// with s = max(1 − R/ρ, 0) the offset from it is h·b + s·u:
//   q = (s²ρ² + h²|b|²)/r²,   ∇q = 2(s·u + h·b)/r².
// s rises with ρ; sρ = max(ρ − R, 0). A disc is convex.
#include "renderer/reference/skeleton_forms.h"

#include <algorithm>

namespace isl::ISL_REFERENCE {
namespace {

class DiscForm final : public SkeletonForm {
 public:
  explicit DiscForm(const scene::Component& component)
      : centre_(interval_of(component.a)),
        axis_(interval_of(component.b)),
        disc_radius_(component.radius_b),
        radius_squared_(square(Interval(component.radius_a))),
        radius_(component.radius_a) {}

  [[nodiscard]] SkeletonExtent extent() const override {
    return {{centre_.x.middle(), centre_.y.middle(), centre_.z.middle()}, disc_radius_, radius_};
  }

  [[nodiscard]] RelativeDistance at(const Vector<Interval>& p) const override {
    const Vector<Interval> w = p - centre_;
    const Interval height = dot(w, axis_) / squared_length(axis_);
    const Vector<Interval> across = w - axis_ * height;
    const Interval rho = square_root(squared_length(across));
    const Interval beyond = positive(rho - Interval(disc_radius_));
    const Interval q = (square(beyond) + square(height) * squared_length(axis_)) / radius_squared_;
    return {q, (across * share_beyond(rho) + axis_ * height) * (Interval(2) / radius_squared_)};
  }

 private:
  [[nodiscard]] static Interval positive(const Interval& x) {
    return {std::max(x.lo, Real(0)), std::max(x.hi, Real(0))};
  }
  [[nodiscard]] Interval share_beyond(const Interval& rho) const {
    const auto at = [&](Real end) {
      return end > 0 ? positive(Interval(1) - Interval(disc_radius_) / Interval(end)) : Interval(0);
    };
    return {at(rho.lo).lo, at(rho.hi).hi};
  }

  Vector<Interval> centre_, axis_;
  Real disc_radius_;
  Interval radius_squared_;
  Real radius_;
};

}  // namespace

SkeletonFormHandle disc_form(const scene::Component& component) { return std::make_shared<DiscForm>(component); }

}  // namespace isl::ISL_REFERENCE
