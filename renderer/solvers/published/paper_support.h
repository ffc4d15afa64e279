// Where a component's field exceeds a level on a ray, and how close the ray comes to the skeleton, for the published
// solver. The sets v ≤ c of all skeletons but the circle are convex, so that there is one interval; it comes from the
// quadratic pieces that the skeleton has along a ray. Of a cone, {q ≤ c} is the hull of two spheres: the ray's ends in
// it lie on one of the spheres, or on the cone between them, where with w = r₀ + kx (cone.h)
//   ρ² / (w² + k²ρ²) = c   ⇔   (1 − ck²) ρ² = c w²,
// and there the least q is where (ρ²)′ w = 2 (w)′ ρ², which along a ray is linear in t. A circle is sampled.
#pragma once

#include "renderer/solvers/published/paper_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace isl::render {

/// Empty unless begin < end.
struct RayInterval {
  double begin = std::numeric_limits<double>::infinity(), end = -begin;

  void extend(double t) {
    begin = std::min(begin, t);
    end = std::max(end, t);
  }
  [[nodiscard]] bool is_empty() const { return !(begin < end); }
};

class ConeOnRay {
 public:
  ConeOnRay(const Cone& cone, const Vec3& origin, const Vec3& direction) : cone_(cone) {
    dd_ = direction.length2();
    centre_ = (cone.a + cone.axis * (0.5 * cone.length) - origin).dot(direction) / dd_;
    direction_ = direction;
    from_a_ = origin + direction * centre_ - cone.a;
    x_ = from_a_.dot(cone.axis);
    dx_ = direction.dot(cone.axis);
    across_ = from_a_ - cone.axis * x_;
    by_ = direction - cone.axis * dx_;
    w_ = cone.radius + cone.slope * x_;
  }

  /// Where q < c.
  [[nodiscard]] RayInterval below(double c) const {
    RayInterval found;
    for (const double u : {0.0, cone_.length}) {
      const Vec3 from_end = from_a_ - cone_.axis * u;
      const double r = cone_.radius_at(u), middle = -from_end.dot(direction_) / dd_;
      const double half2 = (c * r * r - (from_end + direction_ * middle).length2()) / dd_;
      if (!(half2 > 0)) continue;
      found.extend(centre_ + (middle - std::sqrt(half2)));
      found.extend(centre_ + (middle + std::sqrt(half2)));
    }
    const double k = cone_.slope, share = 1 - c * k * k;
    if (!(share > 0)) return found;  // the thick sphere holds all others
    // p₂ t² + 2 p₁ t + p₀ < 0
    const double p2 = share * by_.length2() - c * k * k * dx_ * dx_;
    const double p1 = share * by_.dot(across_) - c * k * dx_ * w_;
    const double p0 = share * across_.length2() - c * w_ * w_;
    const double discriminant = p1 * p1 - p2 * p0;
    if (!(discriminant > 0)) return found;
    const double sum = -(p1 + std::copysign(std::sqrt(discriminant), p1));
    for (const double t : {sum / p2, p0 / sum}) {
      const double w = w_ + k * dx_ * t, u = x_ + dx_ * t + k * (across_ + by_ * t).length2() / w;
      if (w > 0 && u >= 0 && u <= cone_.length) found.extend(centre_ + t);
    }
    return found;
  }

  /// The least q on the line.
  [[nodiscard]] double least() const {
    double least = std::numeric_limits<double>::infinity();
    for (const double u : {0.0, cone_.length}) {
      const Vec3 from_end = from_a_ - cone_.axis * u;
      const double r = cone_.radius_at(u), middle = -from_end.dot(direction_) / dd_;
      if (r > 0) least = std::min(least, (from_end + direction_ * middle).length2() / (r * r));
    }
    const double k = cone_.slope, middle = -by_.dot(across_) / by_.length2();
    const double p = (across_ + by_ * middle).length2(), w_there = w_ + k * dx_ * middle;
    const double t = middle + k * dx_ * p / (by_.length2() * w_there);
    const double w = w_ + k * dx_ * t, rho2 = (across_ + by_ * t).length2(), u = x_ + dx_ * t + k * rho2 / w;
    if (w > 0 && u >= 0 && u <= cone_.length) least = std::min(least, rho2 / (w * w + k * k * rho2));
    return least;
  }

 private:
  const Cone& cone_;
  Vec3 direction_, from_a_, across_, by_;
  double dd_, centre_, x_, dx_, w_;
};

/// Samples on a ray through a circle's support: a stretch thinner than their distance goes unseen, as the mode allows.
class CircleOnRay {
 public:
  CircleOnRay(const FieldLine& line, const Circle& circle) : line_(line) {
    const double dd = line.direction.length2(), spread = ComponentTable::support_root(line.group) * std::sqrt(dd);
    const auto farthest = [&](const Vec3& n) {
      const Reach reach = circle.reach(n)[0];
      return reach.coordinate + reach.radius * spread;
    };
    const double start = line.origin.dot(line.direction);
    low_ = (-farthest(-line.direction) - start) / dd;
    step_ = ((farthest(line.direction) - start) / dd - low_) / kSteps;
    for (int i = 0; i <= kSteps; ++i) v_[static_cast<std::size_t>(i)] = line.at(low_ + step_ * i).v;
    // Half a step changes the distance by no more than its own length.
    most_change_ = 0.5 * step_ * std::sqrt(dd * ComponentTable::v_scale(line.group)) / circle.radius;
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
    if constexpr (std::is_same_v<Shape, Cone>) {
      const ConeOnRay cone(shape, line.origin, line.direction);
      found.least = scale * cone.least();
      if (found.least < level) found.below = cone.below(level / scale);
    } else if constexpr (std::is_same_v<Shape, Circle>) {
      const CircleOnRay circle(line, shape);
      found = {circle.below(level), circle.least()};
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
