// cone: points whose distance from the axis is at most R(s) = radius_a + k s, s from 0 to L along it, k = (radius_b −
// radius_a)/L. Either radius may be zero.
//
// With o, d across the axis written o′, d′, the height s = s₀ + δ t and R = R₀ + k δ t, the side is
//   A t² + 2 B t + C = 0,   A = d′·d′ − (kδ)²,   B = o′·d′ − R₀ kδ,   C = o′·o′ − R₀².
// Expanding B² − A C, the terms (R₀ kδ)² and (o′·d′)² − o′² d′² = −|o′ × d′|² drop out, and
//   D = |R₀ d′ − kδ o′|² − |o′ × d′|² = (|v| − w)(|v| + w),
// which for k = 0 is the cylinder's perpendicular form: no squares of squares cancel. The quadratic is set up at the
// line's point nearest the middle of the axis, so that a far origin costs no digits of the shape.
//
// One nappe (R > 0) is convex, so a line is inside it
//   A > 0: between the two roots, if these lie on that nappe (they lie on the same one);
//   A < 0: from its only root there towards growing R (the other root is on the other nappe);
//   A = 0: from t = −C/2B towards growing R if f falls that way: the line is parallel to a generator and meets one
//   nappe.
// On the surface (C = 0 at t = 0) the other root is −2B/A.
#include "renderer/solids/line_interval.h"

#include <cmath>

namespace isl::render {
namespace {

/// The quadratic of the head comment, for t counted from a point of the line.
struct Side {
  Vec3 across_origin, across_direction;
  double radius;    ///< R at t = 0
  double widening;  ///< kδ: growth of R with t
  double a, b, c;

  Side(const Axis& axis, double radius_a, double slope, const Vec3& offset, const Vec3& direction)
      : across_origin(axis.across(offset)),
        across_direction(axis.across(direction)),
        radius(radius_a + slope * offset.dot(axis.along)),
        widening(slope * direction.dot(axis.along)) {
    const double across = across_direction.length();
    a = (across - std::abs(widening)) * (across + std::abs(widening));
    b = across_origin.dot(across_direction) - radius * widening;
    const double start = across_origin.length();
    c = (start - radius) * (start + radius);
  }
};

/// A half-line that ends at t, towards growing R.
LineInterval towards_wider(const Side& side, double t, bool known) {
  const LineEnd end{t, kSide, known};
  return side.widening > 0 ? LineInterval::from(end) : LineInterval::up_to(end);
}

LineInterval from_surface(const Side& side) {
  if (side.a > 0) return LineInterval::between({0, kSide, true}, {-2 * side.b / side.a, kSide, false});
  if (side.a < 0) return towards_wider(side, 0, true);
  // The line is parallel to a generator and inside where B t < 0. With B = 0 it is a generator itself.
  if (side.b == 0) return LineInterval::none();
  const LineEnd start{0, kSide, true};
  return side.b < 0 ? LineInterval::from(start) : LineInterval::up_to(start);
}

LineInterval nappe_interval(const Side& side) {
  if (side.a == 0) {
    if (side.widening == 0) return side.radius > 0 && side.c < 0 ? LineInterval{} : LineInterval::none();
    // 2 B t + C < 0 towards growing R; towards shrinking R it is the other nappe that the line enters.
    if (side.b == 0 || (side.b < 0) != (side.widening > 0)) return LineInterval::none();
    return towards_wider(side, -side.c / (2 * side.b), false);
  }
  const double v = (side.across_direction * side.radius - side.across_origin * side.widening).length();
  const double w = side.across_origin.cross(side.across_direction).length();
  double discriminant = (v - w) * (v + w);
  if (side.a > 0) {
    if (!(discriminant > 0)) return LineInterval::none();
    // Both roots lie on the nappe of their midpoint.
    if (!(side.radius - side.widening * (side.b / side.a) > 0)) return LineInterval::none();
  } else if (!(discriminant > 0)) {
    discriminant = 0;  // steeper than the side: the line meets both nappes, at the least at the apex
  }
  const double q = -(side.b + std::copysign(std::sqrt(discriminant), side.b));
  const double t0 = q / side.a;
  const double t1 = q == 0 ? 0 : side.c / q;
  if (side.a > 0) return LineInterval::between({t0, kSide}, {t1, kSide});
  return towards_wider(side, side.widening > 0 ? std::max(t0, t1) : std::min(t0, t1), false);
}

void shift(LineInterval& interval, double t) {
  interval.low.t += t;
  interval.high.t += t;
}

Crossings cone_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction, std::uint32_t start_part,
                         const SolidDetails&) noexcept {
  const Axis axis(solid);
  const double dd = direction.dot(direction);
  if (!axis.valid || !(dd > 0)) return {};
  const double slope = (solid.radius_b - solid.radius_a) / axis.length;
  LineInterval side;
  if (start_part == kSide) {
    side = from_surface(Side(axis, solid.radius_a, slope, origin - solid.a, direction));
  } else {
    const Vec3 to_middle = (solid.a + solid.b) * 0.5 - origin;
    const double nearest = to_middle.dot(direction) / dd;
    side = nappe_interval(Side(axis, solid.radius_a, slope, (origin - solid.a) + direction * nearest, direction));
    shift(side, nearest);
  }
  const LineInterval slab = slab_interval(solid, axis, origin, direction, start_part);
  if (solid.open) return open_crossings(side, slab);
  if (side.empty()) return {};
  if (start_part == kCapA || start_part == kCapB) side.hold_origin();
  return closed_crossings(intersection(side, slab));
}

Vec3 cone_normal(const scene::Solid& solid, std::uint32_t part, const Vec3& point, const SolidDetails&) noexcept {
  const Axis axis(solid);
  if (part == kCapA) return -axis.along;
  if (part == kCapB) return axis.along;
  const double slope = (solid.radius_b - solid.radius_a) / axis.length;
  const Vec3 across = axis.across(point - solid.a);
  if (across.length() == 0) return slope > 0 ? -axis.along : axis.along;
  return (across.normalized() - axis.along * slope).normalized();
}

Crossings cone_boundary(const scene::Solid& solid, const Vec3& origin, const Vec3& direction, std::uint32_t start_part,
                        const SolidDetails& details) noexcept {
  return capped_boundary(cone_crossings, solid, origin, direction, start_part, details);
}

Box cone_bounds(const scene::Solid& solid, const SolidDetails&) noexcept {
  return capped_bounds(solid, solid.radius_b);
}

double cone_support(const scene::Database&, const scene::Solid& solid, const Vec3& direction) {
  return capped_support(solid, solid.radius_b, direction);
}

bool is_in_cone(const scene::Database&, const scene::Solid& solid, const Vec3& point) {
  return is_in_capped(solid, solid.radius_b, point);
}

}  // namespace

constinit const SolidType kinds::cone{.crossings = cone_crossings,
                                      .boundary = cone_boundary,
                                      .normal = cone_normal,
                                      .bounds = cone_bounds,
                                      .support = cone_support,
                                      .is_inside = is_in_cone};

}  // namespace isl::render
