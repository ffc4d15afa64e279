// One function for each skeleton: it takes a component's record and returns q as a function of points.
#pragma once

#include "renderer/reference/jet.h"
#include "renderer/reference/reference_skeleton.h"

#include <functional>

namespace isl::ISL_REFERENCE {

using SquaredDistance = std::function<Jet(const Vector<Jet>&)>;

/// p − a, where a is exact to its own interval and does not move.
[[nodiscard]] inline Vector<Jet> from(const Vector<Interval>& a, const Vector<Jet>& p) {
  return {p.x - a.x, p.y - a.y, p.z - a.z};
}
[[nodiscard]] inline Vector<Jet> times(const Vector<Interval>& e, const Jet& s) { return {s * e.x, s * e.y, s * e.z}; }

/// The squared distance from the segment from a to b, whose ends are a and a + e.
class Segment {
 public:
  Segment() = default;
  Segment(const Vector<Interval>& a, const Vector<Interval>& b) : a_(a), e_(b - a), length2_(squared_length(e_)) {
    if (has_length()) unit_ = e_ * (Interval(1) / length2_);
  }

  [[nodiscard]] Jet operator()(const Vector<Jet>& p) const {
    const Vector<Jet> w = from(a_, p);
    if (!has_length()) return squared_length(w);
    const Jet u = dot(w, unit_);
    // Beside the line, and before or behind the ends.
    return squared_length(w - times(e_, u)) + (positive_square(-u) + positive_square(u - Interval(1))) * length2_;
  }
  [[nodiscard]] bool has_length() const { return length2_.lo() > 0; }
  [[nodiscard]] const Interval& squared_length_of() const { return length2_; }

 private:
  Vector<Interval> a_, e_, unit_;  ///< unit_: e/e², whose product with a point is its place along e
  Interval length2_;
};

[[nodiscard]] SquaredDistance limb_distance(const scene::Component& component);
[[nodiscard]] SquaredDistance triangle_distance(const scene::Component& component, const scene::Vec3& third_corner);
[[nodiscard]] SquaredDistance ring_distance(const scene::Component& component);

}  // namespace isl::ISL_REFERENCE
