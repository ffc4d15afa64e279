// The plans have their numbers in POV-Ray 3.7, where their values were measured: the reach of borders is the radius of
// the circle in the smallest polygon, and the values give the numbering of the kinds. Sides have length 1 unless a plan
// states another length.
#include "renderer/patterns/kinds/periodic_polygons.h"

#include <ImathVec.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

namespace isl::render {
namespace {

using Point = Imath::V2d;

constexpr double kSqrt2 = std::numbers::sqrt2, kSqrt3 = std::numbers::sqrt3;
constexpr double kHeight = kSqrt3 / 2;             ///< of a triangle, and half of a hexagon's
constexpr double kInTriangle = kSqrt3 / 6;         ///< radius of the circle in a triangle
constexpr double kHalfOctagon = (1 + kSqrt2) / 2;  ///< and in an octagon
constexpr double kHalfDodecagon = 1 + kSqrt3 / 2;  ///< and in a dodecagon

/// A convex polygon with its corners counter-clockwise.
struct Polygon {
  int kind;
  std::vector<Point> corners;
  std::vector<double> reaches{};  ///< of the sides, the one from the first corner first; empty: the plan's
};

struct Plan {
  int kinds;
  double reach;
  Point first, second;  ///< the polygons repeat along these
  std::vector<Polygon> polygons;
};

Point direction(double degrees) noexcept {
  const double angle = degrees * std::numbers::pi / 180;
  return {std::cos(angle), std::sin(angle)};
}

/// A regular polygon with sides of 1. The first side starts in `corner` and goes in the direction of so many degrees.
Polygon regular(int kind, int sides, Point corner, double degrees) {
  Polygon polygon{kind, {}};
  for (int i = 0; i < sides; ++i) {
    polygon.corners.push_back(corner);
    corner += direction(degrees + 360.0 / sides * i);
  }
  return polygon;
}

Polygon rectangle(int kind, const Point& low, double width, double height) {
  return {kind, {low, low + Point(width, 0), low + Point(width, height), low + Point(0, height)}};
}

// ---- Plans that are made from others --------------------------------------------------------------------------------

/// Squares of side √2 in frames of four trapezia: below, right, above, left.
Plan framed_squares(int kinds, int square, const std::array<int, 4>& frame) {
  const double unit = kSqrt2 / 2, size = 4 * unit;
  const Point outer[] = {{0, 0}, {size, 0}, {size, size}, {0, size}};
  const Point inner[] = {{unit, unit}, {3 * unit, unit}, {3 * unit, 3 * unit}, {unit, 3 * unit}};
  Plan plan{kinds, unit / 2, {size, 0}, {0, size}, {rectangle(square, {unit, unit}, kSqrt2, kSqrt2)}};
  // On the diagonals POV-Ray prefers the trapezia below and above.
  for (const std::size_t i : {0, 2, 1, 3}) {
    const std::size_t next = (i + 1) % 4;
    plan.polygons.push_back({frame[i], {outer[i], outer[next], inner[next], inner[i]}});
  }
  return plan;
}

/// A hexagon with squares on its sides and triangles between them.
Plan hexagons_and_squares(int kinds, int hexagon, const std::array<int, 3>& squares,
                          const std::array<int, 2>& triangles) {
  return {kinds,
          kInTriangle,
          {0, 1 + kSqrt3},
          {kHeight + 1.5, kHeight + 0.5},
          {regular(hexagon, 6, {-1.5, -kHeight}, 0), regular(squares[0], 4, {-1.5, kHeight}, 0),
           regular(squares[1], 4, {0, 0}, 30), regular(squares[2], 4, {-0.5, -kHeight}, -30),
           regular(triangles[0], 3, {-0.5, kHeight}, 30), regular(triangles[1], 3, {-1.5, 1 + kHeight}, 210)}};
}

/// Hexagons among triangles, each corner one of a hexagon and four triangles: eight triangles for a hexagon, the
/// upright ones of kind 0. The plan is left-handed, or mirrored.
Plan hexagons_and_triangles(const Point& hexagon, const Point& first, const Point& second,
                            const std::array<Point, 4>& upright, const std::array<Point, 4>& hanging) {
  Plan plan{3, kInTriangle, first, second, {regular(2, 6, hexagon, 0)}};
  for (const Point& corner : upright) plan.polygons.push_back(regular(0, 3, corner, 0));
  for (const Point& corner : hanging) plan.polygons.push_back(regular(1, 3, corner, 60));
  return plan;
}

/// Dodecagons with squares and hexagons between them.
Plan dodecagons_and_hexagons(int kinds, int dodecagon, const std::array<int, 3>& squares) {
  const double apart = 2 * kHalfDodecagon + 1;
  return {kinds,
          0.5,
          {apart, 0},
          {apart / 2, apart * kHeight},
          {regular(dodecagon, 12, {-0.5, 0.5 - 2 * kHalfDodecagon}, 0), regular(0, 6, {-0.5, 0.5}, 0),
           regular(0, 6, {-0.5, 0.5 - 2 * kHalfDodecagon - kSqrt3}, 0),
           regular(squares[0], 4, {kHalfDodecagon, -kHalfDodecagon}, 0), regular(squares[1], 4, {0.5 + kHeight, 0}, 60),
           regular(squares[2], 4, {-0.5 - kHeight, 0}, 30)}};
}

/// Dodecagons and triangles. In POV-Ray the borders of a dodecagon reach further, 1/3, on the sides that face left,
/// right and up.
Plan dodecagons_and_triangles() {
  Polygon dodecagon = regular(2, 12, {-0.5, 0.5 - 2 * kHalfDodecagon}, 0);
  dodecagon.reaches.assign(12, kInTriangle);
  for (const std::size_t side : {0, 3, 9}) dodecagon.reaches[side] = 1.0 / 3;
  return {3,
          kInTriangle,
          {2 * kHalfDodecagon, 0},
          {kHalfDodecagon, kHalfDodecagon * kSqrt3},
          {dodecagon, regular(0, 3, {-0.5, 0.5}, 0), regular(1, 3, {-kHalfDodecagon, -kHeight}, 60)}};
}

/// Bricks of 2 by 1, lying as kind 0 or standing as kind 1.
Polygon lying(int kind, double x, double z) { return rectangle(kind, {x, z}, 2, 1); }
Polygon standing(int kind, double x, double z) { return rectangle(kind, {x, z}, 1, 2); }

std::vector<Plan> all_plans() {
  const double h = kHeight, snub = h + 0.5, octagon = 2 * kHalfOctagon;
  return {
      /* 1 */ {1, 0.5, {1, 0}, {0, 1}, {regular(0, 4, {0, 0}, 0)}},
      /* 2 */ {1, h, {0, kSqrt3}, {1.5, h}, {regular(0, 6, {0, 0}, 0)}},
      /* 3 */ {2, kInTriangle, {1, 0}, {0.5, h}, {regular(0, 3, {0, 0}, 0), regular(1, 3, {1, 0}, 60)}},
      /* 4 */ {1, h / 2, {1, 0}, {0.5, h}, {{0, {{0, 0}, {1, 0}, {1.5, h}, {0.5, h}}}}},
      /* 5 */
      {3,
       h / 2,
       {3, 0},
       {1.5, h},
       {{0, {{-1.5, -h}, {-0.5, -h}, {0, 0}, {-1, 0}}},
        {1, {{0, -kSqrt3}, {0.5, -h}, {0, 0}, {-0.5, -h}}},
        {2, {{0.5, -h}, {1.5, -h}, {1, 0}, {0, 0}}}}},
      /* 6 */ {2, 0.5, {1, 1}, {2, -2}, {standing(1, 0, 0), lying(0, 1, 0)}},
      /* 7 */
      {2,
       0.5,
       {octagon, 0},
       {0, octagon},
       {regular(1, 8, {-0.5, -kHalfOctagon}, 0), regular(0, 4, {kHalfOctagon, 0.5}, 45)}},
      /* 8 */
      {3,
       kInTriangle,
       {1, 0},
       {0.5, 1 + h},
       {regular(2, 4, {0, 0}, 0), regular(0, 3, {0, 1}, 0), regular(1, 3, {1, 1}, 60)}},
      /* 9 */
      {3,
       kInTriangle,
       {2, 0},
       {1, kSqrt3},
       {regular(2, 6, {0, 0}, 0), regular(0, 3, {-1, 0}, 0), regular(1, 3, {0.5, -h}, 60)}},
      /* 10 */ {1, 0.5, {1, 0}, {0.5, 1}, {regular(0, 4, {0, 0}, 0)}},
      /* 11 */
      {3,
       0.5,
       {3, 0},
       {0, 3},
       {regular(0, 4, {1, 1}, 0), lying(1, 0, 2), lying(1, 1, 0), standing(2, 2, 1), standing(2, 0, 0)}},
      /* 12 */
      {3,
       0.5,
       {6, 0},
       {3, 3},
       {standing(2, -4, 1), standing(2, -3, 1), standing(2, -4, 3), standing(2, -3, 3), lying(1, -2, 2), lying(1, 0, 2),
        lying(1, -2, 3), lying(1, 0, 3), regular(0, 4, {-2, 4}, 0), regular(0, 4, {-2, 1}, 0)}},
      /* 13 */ framed_squares(3, 0, {1, 2, 1, 2}),
      /* 14 */ framed_squares(5, 4, {2, 0, 3, 1}),
      /* 15 */ {2, 0.5, {2, 1}, {-1, 2}, {regular(0, 4, {0, 0}, 0), rectangle(1, {-2, 0}, 2, 2)}},
      /* 16 */ hexagons_and_squares(3, 2, {0, 0, 0}, {1, 1}),
      /* 17 */ hexagons_and_squares(6, 5, {0, 1, 2}, {3, 4}),
      /* 18 */ {2, 0.5, {4, 0}, {2, 2}, {standing(1, -4, 0), standing(1, -3, 0), lying(0, -2, 0), lying(0, -2, 1)}},
      /* 19 */
      hexagons_and_triangles({-1.5, -h}, {2, 2 * h}, {2.5, -h}, {{{-2.5, -h}, {-0.5, -h}, {0, 0}, {-1.5, h}}},
                             {{{-1, -2 * h}, {-2.5, -h}, {-2, 0}, {0, 0}}}),
      /* 20 */
      hexagons_and_triangles({0, -2 * h}, {0.5, 3 * h}, {-2, 2 * h},
                             {{{0.5, -3 * h}, {-1, -2 * h}, {1, -2 * h}, {0, 0}}},
                             {{{0.5, -3 * h}, {-0.5, -h}, {1.5, -h}, {0, 0}}}),
      /* 21 */
      {6,
       kInTriangle,
       {snub, snub},
       {snub, -snub},
       {regular(0, 3, {0, -0.5}, 30), regular(2, 3, {0, 0.5}, 210), regular(1, 3, {0, 0.5}, 60),
        regular(3, 3, {-0.5, snub}, 0), regular(4, 4, {h, 0}, 60), regular(5, 4, {0, 0.5}, 120)}},
      /* 22 */ dodecagons_and_triangles(),
      /* 23 */ dodecagons_and_hexagons(3, 2, {1, 1, 1}),
      /* 24 */ dodecagons_and_hexagons(5, 4, {1, 2, 3}),
  };
}

/// POV-Ray lifts the values of some kinds, or those of their middles alone: the value of a middle then lies above an
/// entry of a map at kind / kinds, whatever rounding does to both.
struct Lift {
  int plan, kind;
  double added, least;  ///< added to kind + 1 − d / reach everywhere; its least fraction, in the middle
};
constexpr Lift kLifts[] = {{8, 2, 1e-7, 0},  {9, 2, 0, 1e-7},  {14, 4, 1e-6, 0}, {15, 1, 2e-8, 0}, {16, 2, 0, 1e-7},
                           {17, 1, 1e-6, 0}, {17, 2, 1e-6, 0}, {17, 5, 0, 1e-6}, {19, 2, 0, 1e-6}, {20, 2, 0, 1e-6},
                           {21, 4, 0, 1e-6}, {21, 5, 0, 1e-6}, {22, 2, 1e-7, 0}, {23, 2, 1e-6, 0}, {24, 4, 1e-6, 0}};

// ---- Looking up -----------------------------------------------------------------------------------------------------

/// Inward distance over reach: (p · inward − offset).
struct Side {
  Point inward;
  double offset;
};

/// The polygons that reach into the parallelogram from the origin along the two directions of a plan.
class Cell {
 public:
  Cell(const Plan& plan, int number)
      : kinds_(plan.kinds), first_(plan.first), second_(plan.second), area_(cross(plan.first, plan.second)) {
    for (const Lift& lift : kLifts) {
      if (lift.plan == number) lifts_[static_cast<std::size_t>(lift.kind)] = lift;
    }
    // The polygons of a plan lie within a few periods from the origin.
    constexpr int kPeriods = 6;
    for (int i = -kPeriods; i <= kPeriods; ++i) {
      for (int j = -kPeriods; j <= kPeriods; ++j) {
        for (const Polygon& polygon : plan.polygons) add(plan, polygon, first_ * i + second_ * j);
      }
    }
  }

  [[nodiscard]] double value(const Point& point) const noexcept {
    const double u = std::floor(cross(point, second_) / area_), v = std::floor(cross(first_, point) / area_);
    const Point p = point - first_ * u - second_ * v;
    // Rounding can put a point on a border outside all polygons; it then belongs to the nearest one.
    double most = -std::numeric_limits<double>::infinity();
    int kind = 0;
    for (const Placed& polygon : polygons_) {
      double inside = std::numeric_limits<double>::infinity();
      for (const Side& side : polygon.sides) {
        inside = std::min(inside, p.dot(side.inward) - side.offset);
        if (inside < most) break;
      }
      if (inside <= most) continue;
      most = inside;
      kind = polygon.kind;
      if (most >= 0) break;
    }
    const Lift& lift = lifts_[static_cast<std::size_t>(kind)];
    return (kind + lift.added + std::max(1 - std::clamp(most, 0.0, 1.0), lift.least)) / kinds_;
  }

 private:
  struct Placed {
    int kind;
    std::vector<Side> sides;
  };

  static double cross(const Point& a, const Point& b) noexcept { return a.x * b.y - a.y * b.x; }

  void add(const Plan& plan, const Polygon& polygon, const Point& offset) {
    Placed placed{polygon.kind, {}};
    const std::size_t count = polygon.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Point corner = polygon.corners[i] + offset;
      const Point along = (polygon.corners[(i + 1) % count] - polygon.corners[i]).normalized();
      const double reach = polygon.reaches.empty() ? plan.reach : polygon.reaches[i];
      const Point inward = Point(-along.y, along.x) / reach;
      placed.sides.push_back({inward, corner.dot(inward)});
    }
    if (!is_outside(polygon, offset)) polygons_.push_back(std::move(placed));
  }

  /// True if the whole polygon lies beyond one of the parallelogram's sides. The test may keep a polygon outside, which
  /// only costs time.
  [[nodiscard]] bool is_outside(const Polygon& polygon, const Point& offset) const noexcept {
    const auto all = [&](auto is_beyond) {
      return std::ranges::all_of(polygon.corners, [&](const Point& corner) {
        const Point p = corner + offset;
        return is_beyond(cross(p, second_) / area_, cross(first_, p) / area_);
      });
    };
    return all([](double u, double) { return u < 0; }) || all([](double u, double) { return u > 1; }) ||
           all([](double, double v) { return v < 0; }) || all([](double, double v) { return v > 1; });
  }

  int kinds_;
  Point first_, second_;
  double area_;
  std::array<Lift, 6> lifts_{};  ///< by kind
  std::vector<Placed> polygons_;
};

const std::vector<Cell>& cells() noexcept {
  static const std::vector<Cell> kCells = [] {
    std::vector<Cell> cells;
    for (const Plan& plan : all_plans()) cells.emplace_back(plan, static_cast<int>(cells.size()) + 1);
    return cells;
  }();
  return kCells;
}

}  // namespace

double periodic_polygons(int plan, const scene::Vec3& p) noexcept {
  return cells()[static_cast<std::size_t>(plan) - 1].value({p.x, p.z});
}

}  // namespace isl::render
