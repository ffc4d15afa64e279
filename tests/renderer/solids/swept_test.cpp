// prism and text: their crossings against outlines that are cut into short lines in long double, without any solving,
// and against POV-Ray's depths.
#include "renderer/solids/capped.h"
#include "renderer/solids/outline.h"
#include "tests/renderer/solids/random_outline.h"

#include "renderer/scene/database.h"

#include <gtest/gtest.h>

#include <numbers>

namespace isl::render::test {
namespace {

using scene::Solid;
using scene::SolidKind;

/// A solid with its outline, as a database and as the tracer hold it.
struct SweptSolid {
  Solid solid;
  scene::Database database;
  SolidDetails details;

  SweptSolid(const Solid& shape, const Outline& outline) : solid(shape) {
    solid.detail = 0;
    database.outlines.push_back(outline);
    details.outlines.push_back(prepare(outline));
  }
  [[nodiscard]] const Outline& outline() const { return database.outlines[0]; }
  [[nodiscard]] Crossings meet(const Vec3& origin, const Vec3& direction, std::uint32_t part = kNoPart) const {
    return crossings(solid, origin, direction, part, details);
  }
};

Outline polygon_of(const std::vector<PlanePoint>& points) {
  Outline outline;
  add_contour(outline, points, std::vector<std::uint8_t>(points.size(), 1));
  return outline;
}

/// Four cubics that differ from the unit circle by less than 3e-4.
Outline round_outline() {
  constexpr double k = 0.5522847498;
  Outline outline;
  add_contour(
      outline,
      {{1, 0}, {1, k}, {k, 1}, {0, 1}, {-k, 1}, {-1, k}, {-1, 0}, {-1, -k}, {-k, -1}, {0, -1}, {k, -1}, {1, -k}},
      {3, 3, 3, 3});
  return outline;
}

SweptSolid random_swept(Random& random) {
  Outline outline = random_outline(random);
  const bool is_text = random.uniform(0, 1) < 0.4;
  outline.is_conic = !is_text && random.uniform(0, 1) < 0.5;
  if (outline.is_conic) outline.fills_by_winding = false;
  const double low = random.uniform(-1, 0.5), high = low + random.uniform(0.1, 1);
  return {{.kind = is_text ? SolidKind::text : SolidKind::prism, .radius_a = low, .radius_b = high}, outline};
}

/// The outline as short lines; `state` tells the inside of a point of the plane, or nothing if the point is too close.
class FlatOutline {
 public:
  explicit FlatOutline(const Outline& outline) : by_winding_(outline.fills_by_winding) {
    std::size_t first = 0, curve = 0;
    for (const std::uint32_t count : outline.contours) {
      for (std::uint32_t i = 0; i < count; ++i, ++curve) {
        const std::size_t n = outline.orders[curve];
        const int pieces = n == 1 ? 1 : kPieces;
        for (int k = 0; k < pieces; ++k)
          lines_.push_back(
              {at(&outline.points[first], n, Real(k) / pieces), at(&outline.points[first], n, Real(k + 1) / pieces)});
        first += n;
      }
      ++first;
    }
  }

  struct Point {
    Real u, v;
  };

  [[nodiscard]] std::optional<bool> state(const Point& p) const {
    int winding = 0;
    for (const auto& [a, b] : lines_) {
      if (distance(p, a, b) < kClose) return std::nullopt;
      if ((a.v <= p.v) == (b.v <= p.v)) continue;
      if (a.u + (b.u - a.u) * (p.v - a.v) / (b.v - a.v) > p.u) winding += b.v > a.v ? 1 : -1;
    }
    return by_winding_ ? winding != 0 : winding % 2 != 0;
  }

 private:
  static constexpr int kPieces = 400;
  /// The lines leave a curve by at most 1/8 of the second derivative, which is below 6·8, over the square of the
  /// pieces.
  static constexpr Real kClose = 5e-5L;

  static Point at(const PlanePoint* p, std::size_t n, Real w) {
    std::array<Point, 4> points;
    for (std::size_t i = 0; i <= n; ++i) points[i] = {p[i].u, p[i].v};
    for (; n > 0; --n) {
      for (std::size_t i = 0; i < n; ++i)
        points[i] = {points[i].u * (1 - w) + points[i + 1].u * w, points[i].v * (1 - w) + points[i + 1].v * w};
    }
    return points[0];
  }
  static Real distance(const Point& p, const Point& a, const Point& b) {
    const Real u = b.u - a.u, v = b.v - a.v, square = u * u + v * v;
    const Real along = square > 0 ? std::clamp<Real>(((p.u - a.u) * u + (p.v - a.v) * v) / square, 0, 1) : 0;
    return std::hypot(p.u - a.u - along * u, p.v - a.v - along * v);
  }

  bool by_winding_;
  std::vector<std::pair<Point, Point>> lines_;
};

/// A random point of the solid's box.
Vec3 aim_at(const SweptSolid& swept, Random& random) {
  const Box box = bounds(swept.solid, swept.details);
  Vec3 aim;
  for (int axis = 0; axis < 3; ++axis) aim[axis] = random.uniform(box.min[axis], box.max[axis]);
  return aim;
}

/// The inside by definition; nothing close to the surface.
std::optional<bool> is_in(const SweptSolid& swept, const FlatOutline& flat, const RealVec& p) {
  const bool is_text = swept.solid.kind == SolidKind::text;
  const Real height = is_text ? p.z : p.y, u = p.x, v = is_text ? p.y : p.z;
  for (const double end : {swept.solid.radius_a, swept.solid.radius_b}) {
    if (std::abs(height - static_cast<Real>(end)) < 1e-6L) return std::nullopt;
  }
  if (height < static_cast<Real>(swept.solid.radius_a) || height > static_cast<Real>(swept.solid.radius_b))
    return false;
  if (!swept.outline().is_conic) return flat.state({u, v});
  return std::abs(height) < 1e-6L ? std::nullopt : flat.state({u / height, v / height});
}

bool inside_after(const Crossings& found, double t) {
  bool inside = false;
  for (int i = 0; i < found.count; ++i) inside ^= found.t[static_cast<std::size_t>(i)] > t;
  return inside;
}

TEST(Swept, is_inside_between_its_crossings) {
  Random random(71);
  int compared = 0, inside = 0;
  for (int i = 0; i < 300; ++i) {
    const SweptSolid swept = random_swept(random);
    const FlatOutline flat(swept.outline());
    for (int line = 0; line < 20; ++line) {
      const Vec3 direction = random.direction() * std::exp2(random.uniform(-10, 10));
      const double near = 1 / direction.length();
      const Vec3 origin = aim_at(swept, random) - direction * (near * random.uniform(-1, 2));
      const Crossings found = swept.meet(origin, direction);
      for (int k = 0; k < 8; ++k) {
        const double t = random.uniform(0, 3) * near;
        const RealVec p = along(origin, direction, t);
        const std::optional<bool> expected = is_in(swept, flat, p);
        if (!expected) continue;
        ASSERT_EQ(inside_after(found, t), *expected) << i << " " << line << " t " << t << " crossings " << found.count;
        ASSERT_EQ(is_inside(swept.database, swept.solid, origin + direction * t), *expected) << i << " " << line;
        ++compared;
        inside += *expected ? 1 : 0;
      }
    }
  }
  EXPECT_GT(compared, 40000);
  EXPECT_GT(inside, 2000);
}

TEST(Swept, is_entered_and_left_in_turn_with_the_normal_outward) {
  Random random(72);
  int on_sides = 0;
  for (int i = 0; i < 300; ++i) {
    const SweptSolid swept = random_swept(random);
    const Box box = bounds(swept.solid, swept.details);
    for (int line = 0; line < 20; ++line) {
      const Vec3 direction = random.direction(), origin = aim_at(swept, random) - direction * 5;
      const Crossings found = swept.meet(origin, direction);
      ASSERT_EQ(found.count % 2, 0);
      for (std::size_t k = 0; k < static_cast<std::size_t>(found.count); ++k) {
        ASSERT_TRUE(k == 0 || found.t[k - 1] <= found.t[k]);
        const Vec3 p = origin + direction * found.t[k];
        for (int axis = 0; axis < 3; ++axis) {
          ASSERT_GE(p[axis], box.min[axis] - 1e-13);
          ASSERT_LE(p[axis], box.max[axis] + 1e-13);
        }
        const Vec3 normal = normal_at(swept.solid, found.part[k], p, swept.details);
        ASSERT_NEAR(normal.length(), 1, 1e-14);
        // Two curves that coincide make intervals of the length of rounding, or gaps. Their normals point anywhere.
        if (k > 0 && found.t[k] - found.t[k - 1] < 1e-12) continue;
        if (k + 1 < static_cast<std::size_t>(found.count) && found.t[k + 1] - found.t[k] < 1e-12) continue;
        const double towards = normal.dot(direction);
        const bool enters = k % 2 == 0;
        ASSERT_TRUE(enters ? towards < 1e-12 : towards > -1e-12) << i << " " << line << " crossing " << k;
        on_sides += std::abs(towards) > 1e-12 && found.part[k] > kCapB ? 1 : 0;
      }
    }
  }
  EXPECT_GT(on_sides, 10000);
}

TEST(Swept, of_a_square_is_a_box) {
  const SweptSolid square({.kind = SolidKind::prism, .radius_a = -0.5, .radius_b = 1},
                          polygon_of({{-1, -1}, {1, -1}, {1, 2}, {-1, 2}}));
  const Solid box{.kind = SolidKind::box, .a = {-1, -0.5, -1}, .b = {1, 1, 2}};
  Random random(73);
  for (int i = 0; i < 20000; ++i) {
    Vec3 direction = random.direction(), origin = random.in_cube(1) - direction * 4;
    // Lines through edges and along faces, too.
    for (int axis = 0; axis < 3; ++axis) {
      if (random.uniform(0, 1) < 0.2) direction[axis] = 0;
      if (random.uniform(0, 1) < 0.2) origin[axis] = std::round(origin[axis]);
    }
    if (direction == Vec3(0)) continue;
    const Crossings a = square.meet(origin, direction), b = crossings(box, origin, direction, kNoPart);
    bool grazes = false;
    for (std::size_t k = 1; k < static_cast<std::size_t>(std::max(a.count, b.count)); k += 2)
      grazes |= (a.count > 0 ? a.t[1] - a.t[0] : b.t[1] - b.t[0]) < 1e-14;
    if (grazes) continue;
    if (a.count != b.count) {
      // A line in the plane of a face is inside or not as rounding has it.
      bool is_in_face = false;
      for (int axis = 0; axis < 3; ++axis)
        is_in_face |= direction[axis] == 0 && (origin[axis] == box.a[axis] || origin[axis] == box.b[axis]);
      ASSERT_TRUE(is_in_face) << origin << direction;
      continue;
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(a.count); ++k) ASSERT_NEAR(a.t[k], b.t[k], 1e-14);
  }
}

TEST(Swept, has_any_number_of_crossings) {
  constexpr int kTeeth = 1000;
  std::vector<PlanePoint> comb{{0, -1}, {kTeeth, -1}};
  for (int i = kTeeth; i > 0; --i) {
    comb.push_back({i - 0.25, 1});
    comb.push_back({i - 0.5, 0});
    comb.push_back({i - 0.75, 1});
  }
  const SweptSolid swept({.kind = SolidKind::prism, .radius_a = 0, .radius_b = 1}, polygon_of(comb));
  const Crossings found = swept.meet({-1, 0.5, 0.5}, {1, 0, 0});
  ASSERT_EQ(found.count, 2 * kTeeth + 2);
  for (int i = 1; i <= kTeeth; ++i) {
    const auto first = static_cast<std::size_t>(2 * i - 1);
    EXPECT_NEAR(found.t[first], i + 0.375, 1e-12);
    EXPECT_NEAR(found.t[first + 1], i + 0.625, 1e-12);
  }
}

struct SurfaceStart {
  Vec3 point, normal;
  std::uint32_t part;
};

std::optional<SurfaceStart> random_start(const SweptSolid& swept, Random& random) {
  const Vec3 direction = random.direction(), origin = aim_at(swept, random) - direction * 4.0;
  const Crossings found = swept.meet(origin, direction);
  if (found.count == 0) return std::nullopt;
  const Vec3 point = origin + direction * found.t[0];
  return SurfaceStart{point, normal_at(swept.solid, found.part[0], point, swept.details), found.part[0]};
}

TEST(Swept, rays_that_leave_a_convex_one_never_meet_it_again) {
  Random random(74);
  for (const bool is_conic : {false, true}) {
    Outline outline = round_outline();
    outline.is_conic = is_conic;
    const SweptSolid swept({.kind = SolidKind::prism, .radius_a = 0.5, .radius_b = 2}, outline);
    int starts = 0;
    while (starts < 50000) {
      const std::optional<SurfaceStart> start = random_start(swept, random);
      if (!start) continue;
      ++starts;
      const double lean = std::pow(10, random.uniform(-14, -0.5));
      ASSERT_EQ(positive(swept.meet(start->point, leaning(start->normal, lean, random), start->part)), 0) << lean;
      const Crossings inward = swept.meet(start->point, leaning(start->normal, -lean, random), start->part);
      ASSERT_LE(positive(inward), 1);
      // Only within rounding of a tangent is the entry the exit already.
      ASSERT_TRUE(positive(inward) == 1 || lean < (is_conic ? 1e-11 : 1e-12)) << lean;
    }
  }
}

TEST(Swept, rays_from_a_surface_meet_the_rest_as_others_do) {
  Random random(75);
  int compared = 0;
  for (int i = 0; i < 300; ++i) {
    const SweptSolid swept = random_swept(random);
    const FlatOutline flat(swept.outline());
    for (int k = 0; k < 20; ++k) {
      const std::optional<SurfaceStart> start = random_start(swept, random);
      if (!start) continue;
      const Vec3 direction = random.direction();
      if (std::abs(direction.dot(start->normal)) < 1e-3) continue;
      const Crossings found = swept.meet(start->point, direction, start->part);
      for (int sample = 0; sample < 8; ++sample) {
        const double t = random.uniform(0, 3);
        const std::optional<bool> expected = is_in(swept, flat, along(start->point, direction, t));
        if (!expected) continue;
        ASSERT_EQ(inside_after(found, t), *expected) << i << " " << k << " t " << t;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 10000);
}

TEST(Swept, reaches_as_far_as_its_points) {
  Random random(76);
  for (int i = 0; i < 200; ++i) {
    const SweptSolid swept = random_swept(random);
    const Box box = bounds(swept.solid, swept.details);
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 direction(0);
      direction[axis] = 1;
      EXPECT_EQ(support(swept.database, swept.solid, direction), box.max[axis]);
    }
    const Vec3 direction = random.direction();
    const double reach = support(swept.database, swept.solid, direction);
    double farthest = -10;
    for (int line = 0; line < 400; ++line) {
      const Vec3 aim = random.direction(), origin = aim_at(swept, random) - aim * 5;
      const Crossings found = swept.meet(origin, aim);
      for (int k = 0; k < found.count; ++k)
        farthest = std::max(farthest, direction.dot(origin + aim * found.t[static_cast<std::size_t>(k)]));
    }
    EXPECT_LE(farthest, reach + 1e-13);
  }
  const SweptSolid round({.kind = SolidKind::prism, .radius_a = 0, .radius_b = 1}, round_outline());
  EXPECT_NEAR(support(round.database, round.solid, {1, 0, 1}), std::numbers::sqrt2, 4e-4);
}

TEST(Swept, a_double_cone_is_met_on_both_sides_of_its_apex) {
  Outline outline = polygon_of({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  outline.is_conic = true;
  const SweptSolid swept({.kind = SolidKind::prism, .radius_a = -1, .radius_b = 2}, outline);
  const Crossings down = swept.meet({0, 5, 0}, {0, -1, 0});
  ASSERT_EQ(down.count, 2) << "the axis runs through the apex and is inside on both sides";
  EXPECT_EQ(down.t[0], 3);
  EXPECT_EQ(down.t[1], 6);
  const Crossings beside = swept.meet({0.5, 5, 0}, {0, -1, 0});
  ASSERT_EQ(beside.count, 4);
  EXPECT_EQ(beside.t[1], 4.5);
  EXPECT_EQ(beside.t[2], 5.5);
  const Vec3 normal = normal_at(swept.solid, beside.part[2], {0.5, -0.5, 0}, swept.details);
  EXPECT_NEAR(normal.x, std::numbers::sqrt2 / 2, 1e-15);
  EXPECT_NEAR(normal.y, std::numbers::sqrt2 / 2, 1e-15);
}

}  // namespace
}  // namespace isl::render::test
