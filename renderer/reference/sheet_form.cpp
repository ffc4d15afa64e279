// The plane through a perpendicular to the unit vector b, as stored in the database: with x = (p − a)·b, q = x²/r² and
// ∇q = 2x b/r². It is
// convex, and along a line it changes only where |x| < r·root.
#include "renderer/reference/skeleton_forms.h"

#include <optional>

namespace isl::ISL_REFERENCE {
namespace {

class SheetForm final : public SkeletonForm {
 public:
  explicit SheetForm(const scene::Component& component)
      : at_(interval_of(component.a)), normal_(interval_of(component.b)), radius_(component.radius_a) {}

  [[nodiscard]] SkeletonExtent extent() const override {
    return {{at_.x.middle(), at_.y.middle(), at_.z.middle()}, kUnbounded, radius_};
  }

  [[nodiscard]] RelativeDistance at(const Vector<Interval>& p) const override {
    const Interval x = height(p), radius_squared = square(Interval(radius_));
    return {square(x) / radius_squared, normal_ * (Interval(2) * x / radius_squared)};
  }

  [[nodiscard]] std::optional<ChangeOnLine> change_on(const Line& line, Real root_q) const override {
    return change_between(height(line.origin), dot(normal_, line.direction), -radius_ * root_q, radius_ * root_q);
  }

 private:
  [[nodiscard]] Interval height(const Vector<Interval>& p) const { return dot(p - at_, normal_); }

  Vector<Interval> at_, normal_;
  Real radius_;
};

}  // namespace

SkeletonFormHandle sheet_form(const scene::Component& component) { return std::make_shared<SheetForm>(component); }

}  // namespace isl::ISL_REFERENCE
