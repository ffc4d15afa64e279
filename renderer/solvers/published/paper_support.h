// The interval of a ray in which a component's field exceeds a given value, and the ray's smallest distance from the
// skeleton, for the published solver. Skeletons that are quadratic in pieces along a ray give both from the pieces; the
// others have a class OnRay of their own, or are sampled. The sets v ≤ c of all skeletons but the circle are convex, so
// that there is one interval.
#pragma once

#include "renderer/solvers/published/paper_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace isl::render {

/// Samples on a ray through a component's support: a stretch thinner than their distance goes unseen, as the mode
/// allows.
class SampledOnRay {
 public:
  template <class Shape>
  SampledOnRay(const FieldLine& line, const Shape& shape) : line_(line) {
    const double dd = line.direction.length2(), spread = ComponentTable::support_root(line.group) * std::sqrt(dd);
    const auto farthest = [&](const Vec3& n) {
      const Reach reach = shape.reach(n)[0];
      return reach.coordinate + reach.radius * spread;
    };
    const double start = line.origin.dot(line.direction);
    low_ = (-farthest(-line.direction) - start) / dd;
    step_ = ((farthest(line.direction) - start) / dd - low_) / kSteps;
    for (int i = 0; i <= kSteps; ++i) v_[static_cast<std::size_t>(i)] = line.at(low_ + step_ * i).v;
    // Half a step changes the distance by no more than its own length.
    most_change_ = 0.5 * step_ * std::sqrt(dd * ComponentTable::v_scale(line.group)) / thinnest(shape);
  }

  /// The interval from the first place with v < level to the last. It may have a gap: a line can leave a torus and come
  /// back.
  [[nodiscard]] RayInterval below(double level) const {
    RayInterval found;
    for (int i = 1; i < kSteps; ++i) {
      if (v_[static_cast<std::size_t>(i)] < level) found.extend(low_ + step_ * i);
    }
    if (found.begin > found.end) return found;
    return {border(found.begin, found.begin - step_, level), border(found.end, found.end + step_, level)};
  }

  /// A lower bound of v on the line.
  [[nodiscard]] double least() const {
    const double root = std::max(std::sqrt(*std::min_element(v_.begin(), v_.end())) - most_change_, 0.0);
    return root * root;
  }

 private:
  static constexpr int kSteps = 256;

  [[nodiscard]] double border(double inner, double outer, double level) const {
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (inner + outer);
      (line_.at(middle).v < level ? inner : outer) = middle;
    }
    return inner;
  }

  const FieldLine& line_;
  double low_, step_, most_change_;
  std::array<double, kSteps + 1> v_;
};

/// The interval where v < level, and a lower bound of v on the line, rounding apart.
struct Nearness {
  RayInterval below;
  double least = std::numeric_limits<double>::infinity();
};

/// Precondition: the component is not a half-space or a sheet.
[[nodiscard]] inline Nearness nearness(const FieldLine& line, double level) {
  Nearness found;
  const double scale = ComponentTable::v_scale(line.group);
  line.table.with_skeleton(line.group, line.item, [&](const auto& shape) {
    using Shape = std::decay_t<decltype(shape)>;
    if constexpr (requires { typename Shape::OnRay; }) {
      const typename Shape::OnRay on_ray(shape, line.origin, line.direction);
      found.least = scale * on_ray.least();
      if (found.least < level) found.below = on_ray.below(level / scale);
    } else if constexpr (!HasPieces<Shape>) {
      const SampledOnRay on_ray(line, shape);
      found = {on_ray.below(level), on_ray.least()};
    } else {
      shape.along(line.origin, line.direction, [&](const QuadraticPiece& q) {
        const double from_middle = std::clamp(q.middle, q.begin, q.end) - q.middle;
        found.least = std::min(found.least, scale * (q.q0 + q.kappa * from_middle * from_middle));
        const double half2 = (level / scale - q.q0) / q.kappa;  // infinite if q does not change
        if (!(half2 > 0)) return;
        const double begin = std::max(q.begin, q.middle - std::sqrt(half2));
        const double end = std::min(q.end, q.middle + std::sqrt(half2));
        if (!(begin < end)) return;
        found.below.extend(begin);
        found.below.extend(end);
      });
    }
  });
  return found;
}

}  // namespace isl::render
