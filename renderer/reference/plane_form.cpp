// The half-space: with x the distance of p before the plane, q = max(x, 0)²/r² and ∇q = 2 max(x, 0) n/r². It is convex,
// and along a line it changes only where 0 < x < r·root.
#include "renderer/reference/skeleton_forms.h"

#include <algorithm>
#include <optional>

namespace isl::ISL_REFERENCE {
namespace {

class PlaneForm final : public SkeletonForm {
 public:
  explicit PlaneForm(const scene::Component& component)
      : at_(interval_of(component.a)), normal_(interval_of(component.b)), radius_(component.radius_a) {}

  [[nodiscard]] SkeletonExtent extent() const override {
    return {{at_.x.middle(), at_.y.middle(), at_.z.middle()}, kUnbounded, radius_};
  }

  [[nodiscard]] RelativeDistance at(const Vector<Interval>& p) const override {
    const Interval x = clamped(height(p), 0, kUnbounded);
    const Interval radius_squared = square(Interval(radius_));
    return {square(x) / radius_squared, normal_ * (Interval(2) * x / radius_squared)};
  }

  [[nodiscard]] std::optional<ChangeOnLine> change_on(const Line& line, Real root_q) const override {
    return change_between(height(line.origin), dot(normal_, line.direction), 0, radius_ * root_q);
  }

 private:
  /// The normal was normalised in double precision by the database; it is used as it is, without normalising it again.
  [[nodiscard]] Interval height(const Vector<Interval>& p) const { return dot(p - at_, normal_); }

  Vector<Interval> at_, normal_;
  Real radius_;
};

}  // namespace

SkeletonFormHandle plane_form(const scene::Component& component) { return std::make_shared<PlaneForm>(component); }

}  // namespace isl::ISL_REFERENCE
