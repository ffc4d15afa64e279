// The box between two corners. Along each axis the offset from the nearest point is the height of p above the upper
// face or below the lower one, independently of the other axes; q = |offset|²/r² and ∇q = 2·offset/r². Inside, the
// offset is zero.
#include "renderer/reference/skeleton_forms.h"

#include "base/check.h"

#include <algorithm>

namespace isl::ISL_REFERENCE {
namespace {

class BoxForm final : public SkeletonForm {
 public:
  explicit BoxForm(const scene::Component& component)
      : low_(component.a), high_(component.b), radius_(component.radius_a) {
    for (int i = 0; i < 3; ++i) ISL_CHECK(low_[i] <= high_[i], "a box from {} to {}", low_[i], high_[i]);
  }

  [[nodiscard]] SkeletonExtent extent() const override {
    const Vector<Interval> half = (interval_of(high_) - interval_of(low_)) * Interval(0.5L);
    const Vector<Interval> centre = interval_of(low_) + half;
    return {{centre.x.middle(), centre.y.middle(), centre.z.middle()}, sqrt(squared_length(half).hi), radius_};
  }

  [[nodiscard]] RelativeDistance at(const Vector<Interval>& p) const override {
    const Vector<Interval> offset{beyond(p.x, low_.x, high_.x), beyond(p.y, low_.y, high_.y),
                                  beyond(p.z, low_.z, high_.z)};
    const Interval radius_squared = square(Interval(radius_));
    return {squared_length(offset) / radius_squared, offset * (Interval(2) / radius_squared)};
  }

 private:
  /// x − (x clamped to [low, high]). It rises with x, so its ends are those of x.
  [[nodiscard]] static Interval beyond(const Interval& x, Real low, Real high) {
    const Interval above = x - Interval(high), below = x - Interval(low);
    const auto end = [&](Real over, Real under) { return over > 0 ? over : std::min(under, Real(0)); };
    return {end(above.lo, below.lo), end(above.hi, below.hi)};
  }

  scene::Vec3 low_, high_;
  Real radius_;
};

}  // namespace

SkeletonFormHandle box_form(const scene::Component& component) { return std::make_shared<BoxForm>(component); }

}  // namespace isl::ISL_REFERENCE
