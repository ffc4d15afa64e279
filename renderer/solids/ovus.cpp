// ovus: an egg about the y axis. A sphere of the bottom radius b = radius_a about the origin, one of the top radius
// t = radius_b about (0, d, 0), and between them a part of the inside of a spindle torus that touches both; b and t are
// at least 0, b ≤ d, and t < b + d.
//
// With ρ the distance from the axis, the outline in the half-plane of ρ and y is three arcs that go over into one
// another without a kink. The middle one has a radius c ≥ (b + t + d)/2 and the centre (−H, V). It touches a circle
// within it where the centres are the difference of the radii apart: H² + V² = (c − b)² and H² + (V − d)² = (c − t)²,
// so with e = t − b and s = 2c − b − t
//   V = (d² + es)/(2d),     d − V = (d² − es)/(2d),     H = √((d − e)(d + e)(s − d)(s + d))/(2d)
// and the arcs meet on the lines through their centres, at the heights −Vb/(c − b) and d + (d − V)t/(c − t). At
// t = b + d the sphere of the top radius would hold all the rest. In POV-Ray 3.7 d is always b, and c = 2 max(b, t).
//
// Each arc about (−h, v) of radius r, turned about the axis, is the border of
//   f = |p − (0, v, 0)|² + 2hρ + (h − r)(h + r) ≤ 0
// for points between the heights where it ends; the spheres have h = 0. Along a line |p − (0, v, 0)|² and ρ are convex
// (a square and a norm) and h is not negative, so split_search.h finds every change of sign for certain. The line is
// cut at the two heights; at the cuts both functions have the same sign, since both arcs go through the same circle.
// The whole is convex, so that there are never more than two crossings.
#include "renderer/solids/solid_type.h"
#include "renderer/solids/split_search.h"

#include <utility>

namespace isl::render {
namespace {

/// An arc of the outline about (−inset, height).
struct Arc {
  double height, inset, radius;

  [[nodiscard]] double value(const Vec3& p) const {
    const double y = p.y - height, square = p.x * p.x + y * y + p.z * p.z;
    return square + 2 * inset * std::sqrt(p.x * p.x + p.z * p.z) + (inset - radius) * (inset + radius);
  }
};

struct Egg {
  /// In a unit of length.
  explicit Egg(const scene::Solid& solid, double unit = 1)
      : bottom_radius(solid.radius_a * unit), top_radius(solid.radius_b * unit) {
    const double b = bottom_radius, t = top_radius;
    distance = solid.a.x > 0 ? solid.a.x * unit : b;
    const double c = solid.a.y > 0 ? solid.a.y * unit : 2 * std::max(b, t);
    const double d = distance, e = t - b, s = (c - b) + (c - t);
    // d − e and d + e are exact where they are small beside d, for a top radius near b + d, and near 0 with d = b.
    const double inset = std::sqrt((d + b - t) / d) * std::sqrt((d - b + t) / d) * std::sqrt(std::max(s - d, 0.0)) *
                         std::sqrt(s + d) / 2;
    const double slant = e / d * s;
    const double above = (d + slant) / 2, below = (d - slant) / 2;  // V, and d − V
    middle = {above, inset, c};
    low_joint = -above * b / (c - b);
    high_joint = d + below * t / (c - t);
  }

  [[nodiscard]] Arc bottom() const { return {0, 0, bottom_radius}; }
  [[nodiscard]] Arc top() const { return {distance, 0, top_radius}; }
  [[nodiscard]] Arc at(double y) const { return y <= low_joint ? bottom() : y >= high_joint ? top() : middle; }
  [[nodiscard]] double highest() const { return distance + top_radius; }

  /// The widest place is at the centre of the arc that it lies on.
  [[nodiscard]] double widest() const {
    if (low_joint >= 0) return bottom_radius;
    return high_joint <= distance ? top_radius : middle.radius - middle.inset;
  }

  double bottom_radius, top_radius;
  double distance;  ///< of their centres
  Arc middle;
  double low_joint, high_joint;  ///< heights between which the middle arc lies
};

/// f of an arc along a line, as a SplitNode.
struct ArcLine {
  Arc arc;
  Vec3 origin, direction;
  double extent;  ///< no coordinate of the line's points is larger

  [[nodiscard]] SplitNode operator()(double t) const {
    const Vec3 p = origin + direction * t;
    const double y = p.y - arc.height, across = p.x * p.x + p.z * p.z, rho = std::sqrt(across);
    const double square = across + y * y, along = p.x * direction.x + p.z * direction.z;
    SplitNode node;
    node.t = t;
    node.u = square + (arc.inset - arc.radius) * (arc.inset + arc.radius);
    node.slope_u = 2 * (along + y * direction.y);
    node.v = -2 * arc.inset * rho;
    // On the axis the norm has a kink; 0 lies between its slopes on both sides.
    node.slope_v = rho > 0 ? -2 * arc.inset * along / rho : 0;
    node.value = node.u - node.v;
    // The sizes of the terms of f add up to no more than 2 (square + inset² + radius²), and each has at most 6
    // roundings of 2⁻⁵³. A coordinate of the point has one of its step, which is at most 2 extent, and one of itself; f
    // changes by at most 2 (√square + inset) times the distance, 2·3√3 (√square + inset) extent ≤ 11 (square + inset² +
    // extent²). 32 of the sum of all hold both, and what inset and height are rounded by.
    node.noise = node.rounding = 0x1p-48 * (square + arc.inset * arc.inset + arc.radius * arc.radius + extent * extent);
    return node;
  }
};

struct OvusStretch {
  double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();

  /// Restricts the stretch to the t where origin + t·direction is between two bounds.
  void cut(double origin, double direction, double low, double high) {
    if (direction == 0) {
      if (!(origin >= low && origin <= high)) to = from;
      return;
    }
    const double a = (low - origin) / direction, b = (high - origin) / direction;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
};

template <Wanted wanted>
Crossings ovus_crossings(const scene::Solid& solid, const Vec3& given_origin, const Vec3& given_direction,
                         std::uint32_t start_part, const SolidDetails&) noexcept {
  Crossings result;
  CrossingsTaker taker(result, wanted);
  const double unit = unit_of(std::max({solid.radius_a, solid.radius_b, solid.a.x}));
  const Vec3 origin = given_origin * unit, direction = given_direction * unit;
  const Egg egg(solid, unit);
  const double widest = egg.widest(), extent = std::max(widest, egg.highest());
  OvusStretch stretch;
  stretch.cut(origin.x, direction.x, -widest, widest);
  stretch.cut(origin.y, direction.y, -egg.bottom_radius, egg.highest());
  stretch.cut(origin.z, direction.z, -widest, widest);
  const bool starts_on_surface = start_part == kSide;
  const bool comes_from_outside = stretch.from > 0 && !starts_on_surface;
  const double base = comes_from_outside ? stretch.from : 0;
  if (!(base < stretch.to)) return result;
  // The search starts at the box, so that a far origin costs the coordinates no digits.
  const Vec3 begin = origin + direction * base;
  const double length = stretch.to - base;
  double low = length, high = length;  // where the line passes the joints; beyond the stretch where it does not
  if (direction.y != 0) {
    low = (egg.low_joint - begin.y) / direction.y;
    high = (egg.high_joint - begin.y) / direction.y;
  }
  if (low > high) std::swap(low, high);
  const double cuts[] = {0, std::clamp(low, 0.0, length), std::clamp(high, 0.0, length), length};
  SplitSearch search(comes_from_outside ? 1 : 0);
  bool starts_here = starts_on_surface;
  for (int i = 0; i < 3; ++i) {
    if (!(cuts[i] < cuts[i + 1])) continue;
    const double middle = begin.y + direction.y * (0.5 * (cuts[i] + cuts[i + 1]));
    const ArcLine line{egg.at(middle), begin, direction, extent};
    search.follow(line, cuts[i], cuts[i + 1], 1, -1, starts_here, [&](double t) { return taker.add(base + t); });
    if (taker.is_done()) return result;
    starts_here = false;
  }
  // Beyond the box everything is outside.
  if (search.sign() < 0) result.add(stretch.to, kSide);
  return result;
}

Vec3 ovus_normal(const scene::Solid& solid, std::uint32_t, const Vec3& point, const SolidDetails&) noexcept {
  const Arc arc = Egg(solid).at(point.y);
  const double rho = std::sqrt(point.x * point.x + point.z * point.z);
  const double along = rho > 0 ? 1 + arc.inset / rho : 1;
  const Vec3 across(point.x * along, point.y - arc.height, point.z * along);
  const double length = across.length();
  // The length is zero only at the tip of an egg whose top radius is 0.
  return length > 0 ? across / length : Vec3(0, 1, 0);
}

Box ovus_bounds(const scene::Solid& solid, const SolidDetails&) noexcept {
  const Egg egg(solid);
  const double widest = egg.widest();
  return {Vec3(-widest, -egg.bottom_radius, -widest), Vec3(widest, egg.highest(), widest)};
}

/// The surface reaches farthest where its normal is the direction, and each arc has the normals between those at its
/// ends: (H, −V)/(c − b) and (H, d − V)/(c − t).
double ovus_support(const scene::Database&, const scene::Solid& solid, const Vec3& direction) {
  const Egg egg(solid);
  const Arc& middle = egg.middle;
  const double length = direction.length(), across = std::hypot(direction.x, direction.z);
  if (direction.y * (middle.radius - egg.bottom_radius) <= -middle.height * length) return egg.bottom_radius * length;
  if (direction.y * (middle.radius - egg.top_radius) >= (egg.distance - middle.height) * length)
    return egg.distance * direction.y + egg.top_radius * length;
  return middle.height * direction.y - middle.inset * across + middle.radius * length;
}

bool is_in_ovus(const scene::Database&, const scene::Solid& solid, const Vec3& point) {
  return Egg(solid).at(point.y).value(point) < 0;
}

double ovus_size(const scene::Database&, const scene::Solid& solid) { return Egg(solid).highest(); }

/// As in POV-Ray, the coordinates are those of a sphere whose centre is at half the top radius.
Coordinates ovus_coordinates(const scene::Solid& solid, const Vec3& point, const Vec3&) noexcept {
  return sphere_coordinates(point - Vec3(0, 0.5 * solid.radius_b, 0));
}

}  // namespace

constinit const SolidType kinds::ovus{.crossings = ovus_crossings<Wanted::all>,
                                      .crossings_to_first = ovus_crossings<Wanted::first>,
                                      .normal = ovus_normal,
                                      .bounds = ovus_bounds,
                                      .support = ovus_support,
                                      .is_inside = is_in_ovus,
                                      .size = ovus_size,
                                      .coordinates = ovus_coordinates};

}  // namespace isl::render
