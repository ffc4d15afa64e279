// Segment: if the foot of p on its line is at v = 0, at the distance ρ, y = ρ² + v², over the part within |v| < W = √(1
// − ρ²).
//
// Circle: if d is the distance of p from it, ρ that from its axis, and k = 4Rρ, then y = d² + k sin²(φ/2), over the |φ|
// < μ where that is below 1. Since sin(φ/2) ≥ φ/π, the distance grows along the arc s = Rφ at least as along a straight
// line that is (π/2)√(R/ρ) shorter.
#include "renderer/reference/reference_curves.h"

#include "renderer/reference/graded_quadrature.h"

#include <algorithm>

namespace isl::ISL_REFERENCE {
namespace {

using Vector3 = Vector<Real>;

Vector3 scaled(const scene::Vec3& v, Real unit) {
  return {static_cast<Real>(v.x) * unit, static_cast<Real>(v.y) * unit, static_cast<Real>(v.z) * unit};
}

class SegmentCurve final : public Curve {
 public:
  SegmentCurve(const scene::Component& c, Real unit) : a_(scaled(c.a, unit)), b_(scaled(c.b, unit)) {
    const Vector3 along = scaled(c.b, unit) - a_;
    length_ = sqrt(squared_length(along));
    if (length_ > 0) axis_ = along * (1 / length_);
  }

  [[nodiscard]] Real distance(const Vector3& p) const override {
    const Place at = place(p);
    const Real beyond = std::max({Real(0), -at.from_a, at.from_a - length_});
    return hypot(at.rho, beyond);
  }

  [[nodiscard]] Integrals integrals(const Vector3& p, const ReferenceWindow& window) const override {
    const Place at = place(p);
    const Real end2 = 1 - at.rho * at.rho;
    if (!(end2 > 0)) return {};
    const Real end = sqrt(end2);
    const Real from = std::max(-at.from_a, -end), to = std::min(length_ - at.from_a, end);
    Real value = 0, across = 0, along = 0;
    if (from < to) {
      integrate_graded(from, to, window.scale(at.rho * at.rho), [&](Real v, Real weight) {
        const ReferenceWindow::Value g = window.at(at.rho * at.rho + v * v, (end - v) * (end + v));
        value += weight * g.value;
        across += weight * g.fall;
        along += weight * g.fall * v;
      });
    }
    return {value, across, at.across * (-2 * across) + axis_ * (2 * along)};
  }

  [[nodiscard]] ReferenceWindow::View view(const Vector3&, Real, Real least) const override {
    return {least, std::min(length_, 2 * sqrt(1 - least)), 1};
  }

 private:
  struct Place {
    Real from_a, rho;
    Vector3 across;
  };
  [[nodiscard]] Place place(const Vector3& p) const {
    const Vector3 from_a = p - a_, from_b = p - b_;
    const Real x = dot(from_a, axis_), beyond = dot(from_b, axis_);
    // The nearer end is used, because the farther one's distance would cost digits.
    const Vector3 across = abs(x) < abs(beyond) ? from_a - axis_ * x : from_b - axis_ * beyond;
    return {x, sqrt(squared_length(across)), across};
  }

  Vector3 a_, b_, axis_{};
  Real length_;
};

class CircleCurve final : public Curve {
 public:
  CircleCurve(const scene::Component& c, Real unit)
      : centre_(scaled(c.a, unit)), axis_(scaled(c.b, 1)), radius_(c.radius_b * unit) {
    axis_ = axis_ * (1 / sqrt(squared_length(axis_)));
  }

  [[nodiscard]] Real distance(const Vector3& p) const override {
    const Place at = place(p);
    return hypot(at.rho - radius_, at.z);
  }

  [[nodiscard]] Integrals integrals(const Vector3& p, const ReferenceWindow& window) const override {
    const Place at = place(p);
    const Real beside = at.rho - radius_, d2 = beside * beside + at.z * at.z;
    if (!(d2 < 1)) return {};
    const Real k = 4 * radius_ * at.rho;
    const bool is_whole = k <= 1 - d2;
    const Real end = is_whole ? kPi : 2 * asin(sqrt((1 - d2) / k));
    // y is singular where k sin²(φ/2) = −scale².
    const Real scale = k > 0 ? 2 * asinh(window.scale(d2) / sqrt(k)) : 2 * kPi;
    Real value = 0, whole = 0, radial = 0;
    integrate_graded(0, end, scale, [&](Real angle, Real weight) {
      const Real half_sine = sin(angle / 2), y = d2 + k * half_sine * half_sine;
      // sin²(μ/2) − sin²(φ/2) = sin((μ + φ)/2) sin((μ − φ)/2)
      const Real to_border = is_whole ? 1 - y : k * sin((end + angle) / 2) * sin((end - angle) / 2);
      const ReferenceWindow::Value g = window.at(y, to_border);
      value += weight * g.value;
      whole += weight * g.fall;
      radial += weight * g.fall * (1 - 2 * half_sine * half_sine);
    });
    const Vector3 outward = at.rho > 0 ? at.across * (1 / at.rho) : Vector3{};
    // p − s = (p − c) − R(cos φ ρ̂ ± sin φ …); both halves of the circle are taken together.
    return {2 * radius_ * value, 2 * radius_ * whole,
            (at.from_centre * whole - outward * (radius_ * radial)) * (-4 * radius_)};
  }

  [[nodiscard]] ReferenceWindow::View view(const Vector3& p, Real ball, Real least) const override {
    const Real nearest_rho = place(p).rho - ball, whole = 2 * kPi * radius_;
    if (!(nearest_rho > 0)) return {least, whole, kUnbounded};
    const Real spread = std::max(Real(1), kPi / 2 * sqrt(radius_ / nearest_rho));
    return {least, std::min(whole, 2 * sqrt(1 - least) * spread), spread};
  }

 private:
  struct Place {
    Real z, rho;
    Vector3 from_centre, across;
  };
  [[nodiscard]] Place place(const Vector3& p) const {
    const Vector3 from = p - centre_;
    const Real z = dot(from, axis_);
    const Vector3 across = from - axis_ * z;
    return {z, sqrt(squared_length(across)), from, across};
  }

  Vector3 centre_, axis_;
  Real radius_;
};

}  // namespace

std::shared_ptr<const Curve> segment_curve(const scene::Component& component, Real unit) {
  return std::make_shared<SegmentCurve>(component, unit);
}
std::shared_ptr<const Curve> circle_curve(const scene::Component& component, Real unit) {
  return std::make_shared<CircleCurve>(component, unit);
}

}  // namespace isl::ISL_REFERENCE
