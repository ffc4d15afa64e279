// torus: the points within r = radius_b of the circle of radius R = radius_a about the y axis.
//
// For r ≤ R its surface is where
//   f = (|p|² − R² − r²)² − 4R²(r² − y²)
// is zero: near the surface both terms are small where r is, unlike those of the textbook's (|p|² + R² − r²)² − 4R²(x²
// + z²). Along the stretch of a line within the ball of radius R + r and the slab |y| ≤ r, f is a quartic over [0, 1];
// its Bernstein coefficients are products of those of |p|² (p₀², p₀·p₁, p₁²) and y. polynomial_roots.h finds brackets
// within which it changes sign once. There Newton's steps on the quartic come near the root, and those on (ρ − R)² +
// y² − r², ρ² = x² + z², take out what the coefficients' rounding, of the size of R⁴, left: its terms are of the size
// of r² near the surface. Where they do not converge within the bracket, the sign change is found to the last digit
// first.
//
// For r > R (a spindle) f is also zero on the lemon within, which bounds nothing, and touches zero where the axis meets
// the surface. There h = (|p|² + R² − r²) − 2Rρ, a difference of two functions that are convex along a line (a square
// and a norm), goes to split_search.h.
//
// The lemon within a spindle is the solid of the major radius −R < 0: h with −2|R|ρ is f's other factor. It lies
// between its tips on the axis, at heights of ±√(r² − R²), and its v is concave.
#include "renderer/numerics/polynomial_roots.h"
#include "renderer/solids/solid_type.h"
#include "renderer/solids/split_search.h"
#include "renderer/solids/torus_search.h"

#include <algorithm>
#include <cmath>

namespace isl::render {
namespace {

double from_axis(const Vec3& p) { return std::sqrt(p.x * p.x + p.z * p.z); }

/// No point is farther from the centre, nor from the plane of the circle.
double reach_of(const scene::Solid& solid) {
  const double big = solid.radius_a, small = solid.radius_b;
  return big < 0 ? std::sqrt((small - big) * (small + big)) : big + small;
}
double height_of(const scene::Solid& solid) { return solid.radius_a < 0 ? reach_of(solid) : solid.radius_b; }

/// The stretch of t > 0 in which the line may meet the torus.
struct TorusStretch {
  double from = 0, to = 0;
  bool comes_from_outside = false;
};

TorusStretch stretch_of(const scene::Solid& solid, const Vec3& origin, const Vec3& direction, bool starts_on_surface) {
  const double reach = reach_of(solid), height = height_of(solid), dd = direction.dot(direction);
  const double middle = -origin.dot(direction) / dd;
  const double distance = (origin + direction * middle).length();
  if (!(distance < reach)) return {};
  const double half = std::sqrt((reach - distance) * (reach + distance) / dd);
  TorusStretch result{middle - half, middle + half};
  if (direction.y != 0) {
    const double a = (-height - origin.y) / direction.y, b = (height - origin.y) / direction.y;
    result.from = std::max(result.from, std::min(a, b));
    result.to = std::min(result.to, std::max(a, b));
  } else if (!(std::abs(origin.y) <= height)) {
    return {};
  }
  result.comes_from_outside = result.from > 0 && !starts_on_surface;
  if (!result.comes_from_outside) result.from = 0;
  return result;
}

using Quartic = FixedBernstein<4>;

/// f along the line from `a` to `b`, and the band of its coefficients.
Quartic quartic(const scene::Solid& solid, const Vec3& a, const Vec3& b, double& band) {
  const double big = solid.radius_a * solid.radius_a, small = solid.radius_b * solid.radius_b;
  const double s0 = a.dot(a) - big - small, s1 = a.dot(b) - big - small, s2 = b.dot(b) - big - small;
  const double y0 = a.y * a.y - small, y1 = a.y * b.y - small, y2 = b.y * b.y - small;
  Quartic p;
  const double four = 4 * big;
  p[0] = s0 * s0 + four * y0;
  p[1] = s0 * s1 + four * 0.5 * (y0 + y1);
  p[2] = (2 * s1 * s1 + s0 * s2) / 3 + four * (y0 + 4 * y1 + y2) / 6;
  p[3] = s1 * s2 + four * 0.5 * (y1 + y2);
  p[4] = s2 * s2 + four * y2;
  // The points are in the ball of radius R + r: |p|² has 5 roundings of at most (R + r)², f as many again of its
  // square.
  const double reach = solid.radius_a + solid.radius_b, largest = 2 * reach * reach;
  band = rounding_of_order(4) * largest * largest;
  return p;
}

/// Newton's steps on the square of the distance while they help; the root is simple wherever they are long. True if the
/// last one was not longer than `shortest`.
bool polish(const scene::Solid& solid, const Vec3& origin, const Vec3& direction, double longest, double shortest,
            double& t) {
  for (int step = 0; step < TorusSearch::kMostSteps; ++step) {
    const Vec3 p = origin + direction * t;
    const double rho = from_axis(p), across = rho - solid.radius_a;
    const double slope = across * (p.x * direction.x + p.z * direction.z) / rho + p.y * direction.y;
    const double move = (across * across + p.y * p.y - solid.radius_b * solid.radius_b) / (2 * slope);
    if (!(std::abs(move) <= longest)) return false;
    t -= move;
    if (std::abs(move) <= shortest) return true;
    longest = 0.5 * std::abs(move);
  }
  return false;
}

/// Calls crossed(t) for the line's crossings from `begin` on, until it returns false, where p is f over the stretch of
/// this length. The sign of f at its end.
template <int n, class Crossed>
int follow(const FixedBernstein<n>& p, double band, int sign, const scene::Solid& solid, const Vec3& begin,
           const Vec3& direction, double length, Crossed&& crossed) {
  SignFollower follower(sign);
  follower.bracket(p, band, [&](double low, double high) {
    double t = follower.root_between(p, low, high, TorusSearch::kNear) * length;
    if (polish(solid, begin, direction, TorusSearch::kMoved * length, TorusSearch::kConverged * length, t) &&
        t >= low * length && t <= high * length)
      return crossed(t);
    t = follower.root_between(p, low, high) * length;
    polish(solid, begin, direction, TorusSearch::kMoved * length, 0, t);
    return crossed(std::clamp(t, 0.0, length));
  });
  return follower.sign();
}

/// h of the head comment, at t.
SplitNode spindle_node(const scene::Solid& solid, const Vec3& origin, const Vec3& direction, double t) {
  const Vec3 p = origin + direction * t;
  const double rho = from_axis(p), square = p.dot(p), big = solid.radius_a, small = solid.radius_b;
  SplitNode node;
  node.t = t;
  node.u = square + (big - small) * (big + small);
  node.slope_u = 2 * p.dot(direction);
  node.v = 2 * big * rho;
  // On the axis the norm has a kink; 0 lies between its slopes on both sides.
  node.slope_v = rho > 0 ? 2 * big * (p.x * direction.x + p.z * direction.z) / rho : 0;
  node.value = node.u - node.v;
  node.noise = node.rounding = 0x1p-49 * (square + big * big + small * small);
  return node;
}

template <Wanted wanted>
Crossings torus_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                          std::uint32_t start_part, const SolidDetails&) noexcept {
  Crossings result;
  CrossingsTaker taker(result, wanted);
  const bool starts_on_surface = start_part == kSide;
  const TorusStretch stretch = stretch_of(solid, origin, direction, starts_on_surface);
  const double length = stretch.to - stretch.from;
  if (!(length > 0)) return result;
  const Vec3 begin = origin + direction * stretch.from;
  const int sign = stretch.comes_from_outside ? 1 : 0;
  int last = 0;
  if (solid.radius_b > solid.radius_a) {
    // The solid is scaled, because squares that overflow would make slopes NaN for the rest of the search.
    const double unit = unit_of(solid.radius_b);
    scene::Solid small = solid;
    small.radius_a *= unit;
    small.radius_b *= unit;
    const Vec3 small_begin = begin * unit, small_direction = direction * unit;
    SplitSearch search(sign);
    search.follow([&](double t) { return spindle_node(small, small_begin, small_direction, t); }, 0, length, 1,
                  solid.radius_a < 0 ? -1 : 1, starts_on_surface,
                  [&](double t) { return taker.add(stretch.from + t); });
    last = search.sign();
  } else {
    double band = 0;
    const Quartic p = quartic(solid, begin, begin + direction * length, band);
    const auto crossed = [&](double t) { return taker.add(stretch.from + t); };
    last = starts_on_surface ? follow(over_u(p), 4 * band, sign, solid, begin, direction, length, crossed)
                             : follow(p, band, sign, solid, begin, direction, length, crossed);
  }
  // Beyond the stretch everything is outside.
  if (last < 0 && !taker.is_done()) result.add(stretch.to, kSide);
  return result;
}

Vec3 torus_normal(const scene::Solid& solid, std::uint32_t, const Vec3& point, const SolidDetails&) noexcept {
  const double rho = from_axis(point);
  // Only a spindle's surface meets the axis. Its normals there form a cone, and the axis is taken instead.
  if (rho == 0) return {0, point.y < 0 ? -1.0 : 1.0, 0};
  const double along = 1 - solid.radius_a / rho;
  const Vec3 across(point.x * along, point.y, point.z * along);
  const double length = across.length();
  return length > 0 ? across / length : Vec3(0, 1, 0);
}

Box torus_bounds(const scene::Solid& solid, const SolidDetails&) noexcept {
  const double widest = solid.radius_a + solid.radius_b;
  const Vec3 corner(widest, height_of(solid), widest);
  return {-corner, corner};
}

double torus_support(const scene::Database&, const scene::Solid& solid, const Vec3& direction) {
  const double height = height_of(solid);
  // The tips of a lemon have a cone of normals.
  if (solid.radius_a < 0 && std::abs(direction.y) * solid.radius_b > height * direction.length())
    return height * std::abs(direction.y);
  return solid.radius_a * std::hypot(direction.x, direction.z) + solid.radius_b * direction.length();
}

bool is_in_torus(const scene::Database&, const scene::Solid& solid, const Vec3& point) {
  return std::hypot(std::hypot(point.x, point.z) - solid.radius_a, point.y) <= solid.radius_b;
}

Coordinates coordinates_of_torus(const scene::Solid& solid, const Vec3& point, const Vec3&) noexcept {
  return torus_coordinates(point, std::abs(solid.radius_a));
}

}  // namespace

constinit const SolidType kinds::torus{.crossings = torus_crossings<Wanted::all>,
                                       .crossings_to_first = torus_crossings<Wanted::first>,
                                       .normal = torus_normal,
                                       .bounds = torus_bounds,
                                       .support = torus_support,
                                       .is_inside = is_in_torus,
                                       .coordinates = coordinates_of_torus};

}  // namespace isl::render
