// The triangle with corners cᵢ, edges eᵢ = cᵢ₊₁ − cᵢ and the normal n = e₀ × (c₂ − c₀), so that eᵢ × n leans outward.
// Its nearest point is the one from which the offset o points along an outward normal, and each of its seven features
// has those for the points p, with w = p − cᵢ, where
//   face      w·(eᵢ × n) ≤ 0 for all i                        o = n(w·n)/|n|²
//   edge i    w·(eᵢ × n) ≥ 0 and 0 ≤ w·eᵢ ≤ |eᵢ|²             o = w − eᵢ(w·eᵢ)/|eᵢ|²
//   corner i  w·eᵢ ≤ 0 and w·eᵢ₋₁ ≥ 0                         o = w
// Every p is in one of the seven, and in several only on their common border, where their offsets agree. For a box, the
// features that it may lie in are combined. q = |o|²/r² and ∇q = 2o/r².
//
// If the corners lie on a line, up to rounding, n has no direction, and the triangle is its edges: the nearest of the
// three counts.
#include "renderer/reference/skeleton_forms.h"

#include "base/check.h"

#include <algorithm>
#include <array>
#include <optional>

namespace isl::ISL_REFERENCE {
namespace {

class TriangleForm final : public SkeletonForm {
 public:
  TriangleForm(const scene::Component& component, const scene::Vec3& third_corner)
      : corners_{interval_of(component.a), interval_of(component.b), interval_of(third_corner)},
        radius_(component.radius_a) {
    for (int i = 0; i < 3; ++i) edges_[i] = corners_[(i + 1) % 3] - corners_[i];
    normal_ = cross(edges_[0], corners_[2] - corners_[0]);
    has_face_ = squared_length(normal_).lo > 0;
    for (int i = 0; i < 3; ++i) outward_[i] = cross(edges_[i], normal_);
  }

  [[nodiscard]] SkeletonExtent extent() const override {
    const Vector<Interval> sum = corners_[0] + corners_[1] + corners_[2];
    const Vector<Real> centre{sum.x.middle() / 3, sum.y.middle() / 3, sum.z.middle() / 3};
    Real half_squared = 0;
    for (const Vector<Interval>& corner : corners_) {
      half_squared = std::max(half_squared, squared_length(corner - Vector<Interval>{centre.x, centre.y, centre.z}).hi);
    }
    return {centre, sqrt(half_squared), radius_};
  }

  [[nodiscard]] RelativeDistance at(const Vector<Interval>& p) const override {
    std::array<Vector<Interval>, 3> w;
    std::array<Interval, 3> outside;
    for (int i = 0; i < 3; ++i) {
      w[i] = p - corners_[i];
      outside[i] = dot(w[i], outward_[i]);
    }
    if (!has_face_) return nearest_edge(w);
    std::optional<Vector<Interval>> offset;
    const auto may_be = [&](const Vector<Interval>& one) { offset = offset ? hull(*offset, one) : one; };
    if (std::ranges::all_of(outside, [](const Interval& side) { return side.lo <= 0; })) {
      may_be(normal_ * (dot(w[0], normal_) / squared_length(normal_)));
    }
    for (int i = 0; i < 3; ++i) {
      const Interval along = dot(w[i], edges_[i]), whole = squared_length(edges_[i]);
      if (outside[i].hi >= 0 && along.hi >= 0 && along.lo <= whole.hi) {
        may_be(w[i] - edges_[i] * clamped(along / whole, 0, 1));
      }
      if (along.lo <= 0 && dot(w[i], edges_[(i + 2) % 3]).hi >= 0) may_be(w[i]);
    }
    ISL_CHECK(offset.has_value(), "a point that is nearest to nothing");
    return distance_of(*offset);
  }

 private:
  [[nodiscard]] RelativeDistance distance_of(const Vector<Interval>& offset) const {
    const Interval radius_squared = square(Interval(radius_));
    return {squared_length(offset) / radius_squared, offset * (Interval(2) / radius_squared)};
  }

  /// The distance from the nearest edge; the gradients of all that may be it are combined.
  [[nodiscard]] RelativeDistance nearest_edge(const std::array<Vector<Interval>, 3>& w) const {
    std::array<RelativeDistance, 3> distances;
    for (int i = 0; i < 3; ++i) {
      const Interval whole = squared_length(edges_[i]);
      const bool has_length = whole.lo > 0;
      distances[i] = distance_of(has_length ? w[i] - edges_[i] * clamped(dot(w[i], edges_[i]) / whole, 0, 1) : w[i]);
    }
    Interval q = distances[0].q;
    for (const RelativeDistance& one : distances) q = {std::min(q.lo, one.q.lo), std::min(q.hi, one.q.hi)};
    std::optional<Vector<Interval>> gradient;
    for (const RelativeDistance& one : distances) {
      if (one.q.lo <= q.hi) gradient = gradient ? hull(*gradient, one.gradient) : one.gradient;
    }
    return {q, *gradient};
  }

  std::array<Vector<Interval>, 3> corners_, edges_, outward_;
  Vector<Interval> normal_;
  Real radius_;
  bool has_face_ = true;
};

}  // namespace

SkeletonFormHandle triangle_form(const scene::Component& component, const scene::Vec3& third_corner) {
  return std::make_shared<TriangleForm>(component, third_corner);
}

}  // namespace isl::ISL_REFERENCE
