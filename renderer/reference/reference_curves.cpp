// Segment: if the foot of p on its line is at v = 0, at the distance ρ, y = ρ² + v², over the part within |v| < w =
// √(1 − ρ²).
//
// Circle: if d is the distance of p from it, ρ that from its axis, and k = 4Rρ, y = d² + k sin²(φ/2) at the angle φ
// from the point nearest to p, over |φ| < μ where y < 1; its poles are where k sin²(φ/2) is minus the square of the
// window's. Since sin(φ/2) ≥ φ/π, the distance grows along the arc Rφ at least as along a straight line that is
// (π/2)√(R/ρ) shorter.
#include "renderer/reference/quadrature.h"
#include "renderer/reference/reference_convolution.h"
#include "renderer/reference/reference_skeleton.h"

#include <algorithm>

namespace isl::ISL_REFERENCE {
namespace {

using Point = Vector<Real>;

Real length_of(const Point& v) { return sqrt(squared_length(v)); }

struct SegmentCurve {
  Point a, b, axis{};
  Real length;

  struct Place {
    Real from_a, rho;
    Point across;
  };
  [[nodiscard]] Place place(const Point& p) const {
    const Point from_a = p - a, from_b = p - b;
    const Real along_a = dot(from_a, axis), along_b = dot(from_b, axis);
    // Seen from the nearer end, because the farther one's distance would cost digits.
    const Point across = abs(along_a) < abs(along_b) ? from_a - axis * along_a : from_b - axis * along_b;
    return {along_a, length_of(across), across};
  }
  [[nodiscard]] Real distance(const Point& p) const {
    const Place at = place(p);
    return hypot(at.rho, std::max({Real(0), -at.from_a, at.from_a - length}));
  }
  [[nodiscard]] Curve::Integrals integrals(const Point& p, const ReferenceWindow& window) const {
    const Place at = place(p);
    const Real rho2 = square(at.rho), end = sqrt(std::max(1 - rho2, Real(0)));
    const Real from = std::max(-at.from_a, -end), to = std::min(length - at.from_a, end);
    if (!(from < to)) return {};
    Real value = 0, fall = 0, along = 0;
    integrate(from, to, window.pole(rho2), [&](Real v, Real weight) {
      const ReferenceWindow::Values g = window.at(rho2 + v * v, (end - v) * (end + v));
      value += weight * g.value;
      fall += weight * g.fall;
      along += weight * g.fall * v;
    });
    return {value, fall, axis * (2 * along) - at.across * (2 * fall)};
  }
  [[nodiscard]] ReferenceWindow::View view(Real least) const {
    return {least, std::min(length, 2 * sqrt(1 - least)), 1};
  }
};

struct CircleCurve {
  Point centre, axis;
  Real radius;

  struct Place {
    Real beside, height;  ///< ρ − R, and the distance from the circle's plane
    Point from_centre, outward;
    Real rho;
  };
  [[nodiscard]] Place place(const Point& p) const {
    const Point from = p - centre;
    const Real height = dot(from, axis);
    const Point across = from - axis * height;
    const Real rho = length_of(across);
    return {rho - radius, height, from, rho > 0 ? across * (1 / rho) : Point{}, rho};
  }
  [[nodiscard]] Real distance(const Point& p) const {
    const Place at = place(p);
    return hypot(at.beside, at.height);
  }
  [[nodiscard]] Curve::Integrals integrals(const Point& p, const ReferenceWindow& window) const {
    const Place at = place(p);
    const Real d2 = square(at.beside) + square(at.height), k = 4 * radius * at.rho;
    if (!(d2 < 1)) return {};
    const bool is_whole = k <= 1 - d2;
    const Real half = is_whole ? 2 * asin(sqrt(Real(0.5L))) : asin(sqrt((1 - d2) / k)), mu = 2 * half;
    const Real pole = k > 0 ? 2 * asinh(window.pole(d2) / sqrt(k)) : 8;
    Real value = 0, fall = 0, turned = 0;  // turned: of −g′ cos φ
    integrate(0, mu, pole, [&](Real angle, Real weight) {
      const Real sine = sin(angle / 2), y = d2 + k * sine * sine;
      // sin²(μ/2) − sin²(φ/2) = sin((μ + φ)/2) sin((μ − φ)/2)
      const Real to_border = is_whole ? 1 - y : k * sin(half + angle / 2) * sin(half - angle / 2);
      const ReferenceWindow::Values g = window.at(y, to_border);
      value += weight * g.value;
      fall += weight * g.fall;
      turned += weight * g.fall * (1 - 2 * sine * sine);
    });
    // Both halves of the circle are taken together: the sum of the offsets from φ and −φ is 2(p − c − R cos φ ρ̂).
    return {2 * radius * value, 2 * radius * fall,
            (at.outward * (radius * turned) - at.from_centre * fall) * (4 * radius)};
  }
  [[nodiscard]] ReferenceWindow::View view(const Point& p, Real ball, Real least) const {
    const Real whole = 8 * asin(sqrt(Real(0.5L))) * radius, rho = place(p).rho - ball;
    if (!(rho > 0)) return {least, whole, kUnbounded};
    const Real spread = std::max(Real(1), 1.5708L * sqrt(radius / rho));
    return {least, std::min(whole, 2 * sqrt(1 - least) * spread), spread};
  }
};

}  // namespace

Curve segment_curve(const scene::Component& c, Real unit) {
  SegmentCurve curve{exactly(c.a) * unit, exactly(c.b) * unit, {}, 0};
  const Point along = (exactly(c.b) - exactly(c.a)) * unit;
  curve.length = length_of(along);
  if (curve.length > 0) curve.axis = along * (1 / curve.length);
  return {std::max(length_of(curve.a), length_of(curve.b)), [=](const Point& p) { return curve.distance(p); },
          [=](const Point& p, const ReferenceWindow& window) { return curve.integrals(p, window); },
          [=](const Point&, Real, Real least) { return curve.view(least); }};
}

Curve circle_curve(const scene::Component& c, Real unit) {
  const Point axis = exactly(c.b);
  const CircleCurve curve{exactly(c.a) * unit, axis * (1 / length_of(axis)), c.radius_b * unit};
  return {length_of(curve.centre) + curve.radius, [=](const Point& p) { return curve.distance(p); },
          [=](const Point& p, const ReferenceWindow& window) { return curve.integrals(p, window); },
          [=](const Point& p, Real ball, Real least) { return curve.view(p, ball, least); }};
}

}  // namespace isl::ISL_REFERENCE
