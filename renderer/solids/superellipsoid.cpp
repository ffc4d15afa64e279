// superellipsoid: (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) ≤ 1, e = radius_a, n = radius_b.
//
// With p = 2/e and q = 2/n it is F = ‖(x, y)‖ₚ^q + |z|^q − 1 ≤ 0, within the cube of ±1. Split at the coordinate
// planes, the line is in one octant on each of at most four pieces, where |x|, |y| and |z| are linear in t. There F has
// the sign of
//   h = r − g,   r = ‖(x, y)‖ₚ,   g = (1 − z^q)^(1/q),
// r is convex in t for p ≥ 1 (a norm of something linear) and concave for p ≤ 1 (the same sum of powers, where
// Minkowski's inequality turns round), and g, whose graph is the border of the unit ball of ‖·‖_q, is concave for q ≥ 1
// and convex for q ≤ 1. So split_search.h finds every crossing for certain. F is what signs are judged by: near the
// poles g loses the digits that F keeps.
//
// With m the larger and k the smaller of |x|, |y|, ρ = (k/m)ᵖ: r = m (1 + ρ)^(1/p), which neither overflows nor
// vanishes for any p, and ∂r/∂m = (r/m)/(1 + ρ), ∂r/∂k = (r/k) ρ/(1 + ρ).
//
// As in POV-Ray, e may be below 0. Then p < 0, for which r is concave too (it is 0 where x or y is), and m is the
// smaller and k the larger, so that ρ stays at most 1. The body reaches the faces of the cube and ends there.
#include "renderer/numerics/power.h"
#include "renderer/solids/line_interval.h"
#include "renderer/solids/solid_type.h"
#include "renderer/solids/split_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isl::render {
namespace {

/// 0^exponent, for a slope: 0, 1 or infinite.
double slope_at_zero(double exponent) { return exponent > 0 ? 0 : (exponent < 0 ? kInfinity : 1); }

/// ∂r/∂m or ∂r/∂k times the coordinate's slope; 0 if the coordinate is constant, even where the derivative is infinite.
double times(double slope, double step) { return step == 0 ? 0 : slope * step; }

struct Ring {
  double r, slope_large, slope_small;
};

/// ‖(large, small)‖ₚ and its derivatives. For p < 0, `large` is the smaller of the two.
Ring ring(double large, double small, double p) {
  if (large == 0) return {0, 1, 0};
  const double rho = power(small / large, p);
  const double r = large * power(1 + rho, 1 / p);
  const double small_slope = small > 0 ? (r / small) * (rho / (1 + rho)) : slope_at_zero(p - 1);
  return {r, r / large / (1 + rho), small_slope};
}

double norm(double x, double y, double p) {
  const auto [smaller, larger] = std::minmax(x, y);
  return p > 0 ? ring(larger, smaller, p).r : ring(smaller, larger, p).r;
}

/// A line in one octant.
class OctantLine {
 public:
  OctantLine(const scene::Solid& solid, const Vec3& origin, const Vec3& direction)
      : p_(2 / solid.radius_a), q_(2 / solid.radius_b), origin_(origin), direction_(direction) {}

  /// Sets the octant by the signs of the coordinates at a point within it.
  void enter_octant_of(const Vec3& point) {
    for (int i = 0; i < 3; ++i) mirror_[i] = point[i] < 0 ? -1 : 1;
  }

  [[nodiscard]] SplitNode operator()(double t) const {
    const Vec3 point = coordinates(t), step = direction_ * mirror_;
    const bool x_is_first = (point.x >= point.y) == (p_ > 0);
    const double step_large = x_is_first ? step.x : step.y, step_small = x_is_first ? step.y : step.x;
    const Ring own = x_is_first ? ring(point.x, point.y, p_) : ring(point.y, point.x, p_);
    SplitNode node;
    node.t = t;
    node.u = own.r;
    if (own.r > 0) {
      node.slope_u = times(own.slope_large, step_large) + times(own.slope_small, step_small);
    } else if (p_ < 0 && point.x + point.y > 0) {  // a coordinate plane: r is the distance from it
      node.slope_u = step_large;
    } else {  // the axis: away from it on both sides
      const double away = norm(std::abs(step.x), std::abs(step.y), p_);
      node.slope_u = step.x + step.y < 0 ? -away : away;
    }
    const double w = power(point.z, q_), rest = 1 - w;
    node.v = power(rest, 1 / q_);
    double slope = 0;  // (z/g)^(q−1)
    if (rest == 0) {
      slope = slope_at_zero(1 - q_);
    } else {
      slope = point.z > 0 ? w / rest * (node.v / point.z) : slope_at_zero(q_ - 1);
    }
    node.slope_v = -times(slope, step.z);
    const double ring_power = power(own.r, q_);
    node.value = ring_power + w - 1;
    // The power function is good to 1e-14, twice in a row for r; coordinates of at most 4 have moved by 2⁻⁵¹.
    constexpr double kPower = 0x1p-44, kPosition = 0x1p-50;
    node.noise = kPower * (1 + ring_power + w);
    if (own.r > 0) node.noise += kPosition * q_ * ring_power / own.r;
    if (point.z > 0) node.noise += kPosition * q_ * w / point.z;
    node.rounding = kPower * (own.r + node.v) + kPosition;
    return node;
  }

  /// True if the line, up to the end of its first octant, begins within the body.
  [[nodiscard]] bool begins_within(double end) {
    enter_octant_of(origin_ + direction_ * (0.5 * end));
    return (*this)(0).sign() < 0;
  }

  [[nodiscard]] int u_bends() const { return p_ >= 1 ? 1 : -1; }
  [[nodiscard]] int v_bends() const { return q_ >= 1 ? -1 : 1; }

 private:
  /// The absolute values of the coordinates; those that rounding makes negative are set to 0.
  [[nodiscard]] Vec3 coordinates(double t) const {
    Vec3 point = (origin_ + direction_ * t) * mirror_;
    for (int i = 0; i < 3; ++i) point[i] = std::max(point[i], 0.0);
    point.z = std::min(point.z, 1.0);
    return point;
  }

  double p_, q_;
  Vec3 origin_, direction_, mirror_{1};
};

/// True for a point on the cube, to the rounding of the way there.
bool is_on_face(const Vec3& point) {
  return std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)}) >= 1 - 0x1p-40;
}

template <Wanted wanted>
Crossings superellipsoid_crossings(const scene::Solid& solid, const Vec3& origin, const Vec3& direction,
                                   std::uint32_t start_part, const SolidDetails&) noexcept {
  Crossings result;
  CrossingsTaker taker(result, wanted);
  double enter = -kInfinity, leave = kInfinity;
  for (int i = 0; i < 3; ++i) {
    if (direction[i] == 0) {
      if (!(std::abs(origin[i]) <= 1)) return result;
      continue;
    }
    const double a = (-1 - origin[i]) / direction[i], b = (1 - origin[i]) / direction[i];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  const bool starts_on_surface = start_part == kSide;
  const bool comes_from_outside = enter > 0 && !starts_on_surface;
  const double base = comes_from_outside ? enter : 0;
  if (!(base < leave)) return result;
  // The search starts at the cube, so that a far origin costs the coordinates no digits.
  const Vec3 begin = origin + direction * base;
  const double length = leave - base;
  double cuts[5] = {0};
  int count = 1;
  for (int i = 0; i < 3; ++i) {
    const double cut = direction[i] == 0 ? -1 : -begin[i] / direction[i];
    if (!(cut > 0 && cut < length)) continue;
    int place = count++;
    for (; cuts[place - 1] > cut; --place) cuts[place] = cuts[place - 1];
    cuts[place] = cut;
  }
  cuts[count] = length;
  OctantLine line(solid, begin, direction);
  const bool enters_by_face = solid.radius_a < 0 && is_on_face(begin) && line.begins_within(cuts[1]);
  if (enters_by_face && comes_from_outside) {
    taker.add(base);
    if (taker.is_done()) return result;
  }
  SplitSearch search(enters_by_face ? -1 : (comes_from_outside ? 1 : 0));
  for (int i = 0; i < count; ++i) {
    if (!(cuts[i] < cuts[i + 1])) continue;
    line.enter_octant_of(begin + direction * (0.5 * (cuts[i] + cuts[i + 1])));
    search.follow(line, cuts[i], cuts[i + 1], line.u_bends(), line.v_bends(),
                  starts_on_surface && i == 0 && !enters_by_face, [&](double t) { return taker.add(base + t); });
    if (taker.is_done()) return result;
  }
  // Beyond the cube everything is outside.
  if (search.sign() < 0) result.add(leave, kSide);
  return result;
}

/// The direction of ∇F; if a component is infinite, the direction of that component alone.
Vec3 superellipsoid_normal(const scene::Solid& solid, std::uint32_t, const Vec3& point, const SolidDetails&) noexcept {
  const double p = 2 / solid.radius_a, q = 2 / solid.radius_b;
  const Vec3 size(std::abs(point.x), std::abs(point.y), std::abs(point.z));
  const double r = norm(size.x, size.y, p);
  const auto slope = [](double base, double exponent) {
    return base > 0 ? power(base, exponent) : slope_at_zero(exponent);
  };
  const double outer = slope(r, q - 1);
  const auto of_ring = [&](double coordinate) { return r > 0 ? times(outer, slope(coordinate / r, p - 1)) : 0; };
  Vec3 gradient(of_ring(size.x), of_ring(size.y), slope(size.z, q - 1));
  bool is_steep = false;
  for (int i = 0; i < 3; ++i) is_steep |= std::isinf(gradient[i]);
  for (int i = 0; i < 3; ++i) {
    if (is_steep) gradient[i] = std::isinf(gradient[i]) ? 1 : 0;
    if (point[i] < 0) gradient[i] = -gradient[i];
  }
  const double length = gradient.length();
  return length > 0 && std::isfinite(length) ? gradient / length : Vec3(0, 0, point.z < 0 ? -1 : 1);
}

Box superellipsoid_bounds(const scene::Solid&, const SolidDetails&) noexcept { return {Vec3(-1), Vec3(1)}; }

/// The norm dual to ‖(x, y)‖ₚ with p = 2/exponent. Below p = 1 the unit ball is not convex; its hull is that of p = 1.
double dual_norm(double x, double y, double exponent) {
  x = std::abs(x);
  y = std::abs(y);
  const double p = 2 / exponent, larger = std::max(x, y);
  if (p <= 1 || larger == 0) return larger;
  const double dual = p / (p - 1);
  return larger * std::pow(std::pow(x / larger, dual) + std::pow(y / larger, dual), 1 / dual);
}

double superellipsoid_support(const scene::Database&, const scene::Solid& solid, const Vec3& direction) {
  if (solid.radius_a < 0) return std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z);
  return dual_norm(dual_norm(direction.x, direction.y, solid.radius_a), direction.z, solid.radius_b);
}

bool is_in_superellipsoid(const scene::Database&, const scene::Solid& solid, const Vec3& point) {
  const double e = solid.radius_a, n = solid.radius_b;
  if (e < 0 && std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)}) > 1) return false;
  const double ring = std::pow(std::abs(point.x), 2 / e) + std::pow(std::abs(point.y), 2 / e);
  return std::pow(ring, e / n) + std::pow(std::abs(point.z), 2 / n) <= 1;
}

double superellipsoid_size(const scene::Database&, const scene::Solid&) { return 1; }

}  // namespace

constinit const SolidType kinds::superellipsoid{.crossings = superellipsoid_crossings<Wanted::all>,
                                                .crossings_to_first = superellipsoid_crossings<Wanted::first>,
                                                .normal = superellipsoid_normal,
                                                .bounds = superellipsoid_bounds,
                                                .support = superellipsoid_support,
                                                .is_inside = is_in_superellipsoid,
                                                .size = superellipsoid_size};

}  // namespace isl::render
