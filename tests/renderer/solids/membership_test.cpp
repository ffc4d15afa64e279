// Box, torus, superellipsoid, ovus and polynomials: along random lines inside and outside alternate exactly where the
// crossings say, from near and far; normals are gradients; rays from a surface neither meet it again nor lose it; boxes
// hold.
#include "tests/renderer/solids/membership.h"

#include <gtest/gtest.h>

namespace isl::render::test {
namespace {

using scene::SolidKind;

/// The size of membership at a point that is `shift` off the surface.
Real value_of_shift(const WholeSolid& whole, const RealVec& p, Real shift) {
  Real largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const Real step : {-shift, shift}) {
      RealVec q = p;
      (axis == 0 ? q.x : axis == 1 ? q.y : q.z) += step;
      largest = std::max(largest, std::abs(membership(whole, q) - membership(whole, p)));
    }
  }
  if (scene::is_polynomial(whole.solid.kind)) {
    // If terms nearly cancel, rounding decides the value: the rounding of the terms on the whole piece of the line.
    const Real m = 2 * std::sqrt(dot(p, p)) + static_cast<Real>(whole.details.polynomials[0].reach);
    largest +=
        polynomial_value(whole.polynomial, {m, m, m}, true) * 0x1p-46L * static_cast<Real>(whole.polynomial.order);
  }
  return largest;
}

/// The state right after t according to the crossings.
bool inside_at(const Crossings& found, double t) {
  bool inside = found.ends_inside;
  for (int i = 0; i < found.count; ++i) inside ^= found.t[i] > t;
  return inside;
}

void expect_alternating(const Crossings& found, const WholeSolid& whole, const Vec3& origin, const Vec3& direction,
                        double reach, double from, double to, Random& random) {
  if (testing::Test::HasFailure()) return;
  const Real shift = 1e-11L * static_cast<Real>(reach);
  const auto kind = static_cast<int>(whole.solid.kind);
  for (int i = 0; i < found.count; ++i) {
    if (!(found.t[i] > 0)) continue;
    const RealVec p = along(origin, direction, found.t[i]);
    if (std::abs(found.t[i]) > 1e4 * reach) continue;
    ASSERT_LE(std::abs(membership(whole, p)), value_of_shift(whole, p, shift) + 1e-12L)
        << "kind " << kind << " t " << found.t[i] << " radii " << whole.solid.radius_a << " " << whole.solid.radius_b;
    ASSERT_TRUE(i == 0 || found.t[i - 1] <= found.t[i]);
  }
  for (int i = 0; i < 16; ++i) {
    const double t = random.uniform(from, to);
    if (!(t > 0)) continue;
    const RealVec p = along(origin, direction, t);
    const Real value = membership(whole, p);
    if (std::abs(value) <= value_of_shift(whole, p, shift)) continue;
    ASSERT_EQ(inside_at(found, t), value < 0)
        << "kind " << kind << " t " << t << " value " << static_cast<double>(value) << " radii " << whole.solid.radius_a
        << " " << whole.solid.radius_b << " crossings " << found.count << " order " << whole.polynomial.order
        << " from " << origin << " along " << direction;
  }
}

void expect_alternating(const WholeSolid& whole, const Vec3& origin, const Vec3& direction, double reach, double from,
                        double to, Random& random) {
  const Crossings found = crossings(whole.solid, origin, direction, kNoPart, whole.details);
  expect_alternating(found, whole, origin, direction, reach, from, to, random);
}

TEST(Membership, alternates_at_the_crossings) {
  Random random(31);
  for (int i = 0; i < 2000; ++i) {
    for (const SolidKind kind : kWholeKinds) {
      const WholeSolid whole = random_whole(random, kind);
      const Vec3 direction = random.direction() * std::exp2(random.uniform(-10, 10));
      const double near = 1 / direction.length();
      const Vec3 origin = random.in_cube(1.2) - direction * (near * random.uniform(-2, 4));
      expect_alternating(whole, origin, direction, 4, 0, 7 * near, random);
    }
  }
}

TEST(Membership, alternates_in_a_stretch_of_a_line) {
  Random random(38);
  int shorter = 0;
  for (int i = 0; i < 4000; ++i) {
    for (const SolidKind kind : {SolidKind::quadric, SolidKind::cubic, SolidKind::quartic, SolidKind::poly}) {
      const WholeSolid whole = random_whole(random, kind);
      const Vec3 direction = random.direction() * std::exp2(random.uniform(-10, 10));
      const double near = 1 / direction.length();
      const Vec3 origin = random.in_cube(1.2) - direction * (near * random.uniform(-2, 4));
      Stretch stretch{std::max(0.0, near * random.uniform(-2, 6)), 0};
      stretch.to = stretch.from + near * std::exp2(random.uniform(-12, 3));
      const Crossings found = boundary(whole.solid, origin, direction, kNoPart, whole.details, stretch);
      expect_alternating(found, whole, origin, direction, 4, stretch.from, stretch.to, random);
      shorter += found.count < boundary(whole.solid, origin, direction, kNoPart, whole.details).count ? 1 : 0;
    }
  }
  EXPECT_GT(shorter, 2000);  // the stretch is made use of
}

TEST(Membership, alternates_along_lines_in_special_directions) {
  Random random(32);
  for (int i = 0; i < 2000; ++i) {
    for (const SolidKind kind : kWholeKinds) {
      const WholeSolid whole = random_whole(random, kind);
      Vec3 direction(0), aim(0);
      direction[static_cast<int>(random.uniform(0, 3))] = random.uniform(0, 1) < 0.5 ? -1 : 1;
      if (random.uniform(0, 1) < 0.3) direction[static_cast<int>(random.uniform(0, 3))] += 1;
      if (direction == Vec3(0)) continue;
      for (int axis = 0; axis < 3; ++axis) {
        if (random.uniform(0, 1) < 0.6) aim[axis] = random.uniform(-1, 1);
      }
      expect_alternating(whole, aim - direction * 3, direction, 4, 0, 6, random);
    }
  }
}

TEST(Membership, alternates_seen_from_a_million_away) {
  Random random(33);
  for (int i = 0; i < 800; ++i) {
    for (const SolidKind kind : kWholeKinds) {
      const WholeSolid whole = random_whole(random, kind);
      const double far = std::pow(10, random.uniform(2, 6));
      const Vec3 direction = random.direction();
      expect_alternating(whole, random.in_cube(1.2) - direction * far, direction, 4 + 20 * far * 1e-5, far - 2, far + 2,
                         random);
    }
  }
}

TEST(Membership, of_polynomials_scales) {
  Random random(34);
  for (int i = 0; i < 3000; ++i) {
    for (const SolidKind kind : {SolidKind::quadric, SolidKind::cubic, SolidKind::quartic, SolidKind::poly}) {
      WholeSolid whole = random_whole(random, kind);
      const Vec3 direction = random.direction(), origin = random.in_cube(2) - direction * 2;
      const Crossings here = crossings(whole.solid, origin, direction, kNoPart, whole.details);
      for (const double scale : {0x1p-10, 0x1p10}) {
        scene::Polynomial scaled = whole.polynomial;
        std::size_t place = 0;
        for (int a = 0; a <= scaled.order; ++a) {
          for (int b = 0; b <= a; ++b) {
            for (int c = 0; c <= b; ++c) scaled.coefficients[place++] *= std::pow(scale, c);
          }
        }
        const WholeSolid large = algebraic(scaled.order, scaled.coefficients);
        const Crossings there = crossings(large.solid, origin * scale, direction, kNoPart, large.details);
        ASSERT_EQ(here.count, there.count);
        for (int k = 0; k < here.count; ++k) ASSERT_EQ(here.t[k] * scale, there.t[k]) << "to the last digit";
      }
    }
  }
}

TEST(Membership, of_a_known_quartic_is_that_of_the_torus) {
  // x⁴ + … is the torus 1, ½ about the z axis.
  const WholeSolid whole = algebraic(4, {1, 0, 0, 0, 2, 0, 0, 2,    0, -2.5, 0, 0, 0, 0, 0,   0, 0,     0,
                                         0, 0, 1, 0, 0, 2, 0, -2.5, 0, 0,    0, 0, 1, 0, 1.5, 0, 0.5625});
  scene::Solid torus;
  torus.kind = SolidKind::torus;
  torus.radius_a = 1;
  torus.radius_b = 0.5;
  Random random(35);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 direction = random.direction(), origin = random.in_cube(1.5) - direction * 4;
    const Crossings a = crossings(whole.solid, origin, direction, kNoPart, whole.details);
    const Crossings b =
        crossings(torus, {origin.x, origin.z, -origin.y}, {direction.x, direction.z, -direction.y}, kNoPart);
    ASSERT_EQ(a.count, b.count);
    for (int k = 0; k < a.count; ++k) {
      EXPECT_NEAR(a.t[k], b.t[k], 1e-6);
      ++hits;
    }
  }
  EXPECT_GT(hits, 1000);
}

TEST(Membership, ends_where_a_polynomials_cube_says) {
  // x⁴ − 5x² + y⁴ − 5y² + z⁴ − 5z² + 11.8, then an unbounded quadric, and one whose highest terms vanish.
  const WholeSolid tangle = algebraic(4, {1, 0, 0, 0, 0, 0, 0, 0,  0, -5, 0, 0, 0, 0, 0,  0, 0,   0,
                                          0, 0, 1, 0, 0, 0, 0, -5, 0, 0,  0, 0, 1, 0, -5, 0, 11.8});
  EXPECT_LT(tangle.details.polynomials[0].cube, 4.5);
  EXPECT_GT(tangle.details.polynomials[0].cube, 2.1);
  EXPECT_TRUE(std::isinf(algebraic(2, {1, 0, 0, 0, 1, 0, 0, -1, 0, -1}).details.polynomials[0].cube));
  EXPECT_TRUE(std::isinf(algebraic(2, {1, 0, 0, 0, 1, 0, 0, 0, 0, -1}).details.polynomials[0].cube)) << "a cylinder";
  EXPECT_NEAR(algebraic(2, {1, 0, 0, 0, 1, 0, 0, 1, 0, -1}).details.polynomials[0].cube, 1, 0.02);
  // No inside lies beyond the cube.
  Random random(38);
  int bounded = 0;
  for (int i = 0; i < 3000; ++i) {
    WholeSolid whole = random_whole(random, SolidKind::quartic);
    scene::Polynomial polynomial = whole.polynomial;
    for (const std::size_t place : {0u, 20u, 30u})
      polynomial.coefficients[place] += random.uniform(0, 8);  // x⁴, y⁴, z⁴
    whole = algebraic(4, polynomial.coefficients);
    const double cube = whole.details.polynomials[0].cube;
    if (!std::isfinite(cube)) continue;
    ++bounded;
    for (int point = 0; point < 50; ++point) {
      Vec3 p = random.in_cube(1);
      p *= cube * random.uniform(1, 3) / std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
      ASSERT_GT(membership(whole, real(p)), 0);
    }
  }
  EXPECT_GT(bounded, 100);
}

TEST(Membership, normals_are_gradients) {
  Random random(36);
  int checked = 0;
  for (int i = 0; i < 800; ++i) {
    for (const SolidKind kind : kWholeKinds) {
      const WholeSolid whole = random_whole(random, kind);
      const Vec3 direction = random.direction(), origin = random.in_cube(1) - direction * 4;
      const Crossings found = crossings(whole.solid, origin, direction, kNoPart, whole.details);
      for (int k = 0; k < found.count; ++k) {
        if (!(found.t[k] > 0 && found.t[k] < 10)) continue;
        const Vec3 point = origin + direction * found.t[k];
        const Vec3 normal = normal_at(whole.solid, found.part[k], point, whole.details);
        ASSERT_NEAR(normal.length(), 1, 1e-14);
        const auto gradient_of = [&](Real step) {
          Vec3 gradient;
          for (int axis = 0; axis < 3; ++axis) {
            RealVec ahead = real(point), behind = real(point);
            (axis == 0 ? ahead.x : axis == 1 ? ahead.y : ahead.z) += step;
            (axis == 0 ? behind.x : axis == 1 ? behind.y : behind.z) -= step;
            gradient[axis] = static_cast<double>((membership(whole, ahead) - membership(whole, behind)) / (2 * step));
          }
          return gradient;
        };
        // If two steps do not agree, there is an edge, or nearly one.
        const Vec3 gradient = gradient_of(1e-7L), coarse = gradient_of(2e-7L);
        if ((gradient - coarse).length() > 1e-5 * gradient.length()) continue;
        ASSERT_LT((normal - gradient.normalized()).length(), 1e-4)
            << static_cast<int>(kind) << " radii " << whole.solid.radius_a << " " << whole.solid.radius_b << " at "
            << point;
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 2000);
}

TEST(Membership, boxes_hold_every_crossing) {
  Random random(37);
  for (int i = 0; i < 800; ++i) {
    for (const SolidKind kind : kWholeKinds) {
      const WholeSolid whole = random_whole(random, kind);
      const Box box = bounds(whole.solid, whole.details);
      const Vec3 direction = random.direction(), origin = random.in_cube(1) - direction * 4;
      const Crossings found = crossings(whole.solid, origin, direction, kNoPart, whole.details);
      for (int k = 0; k < found.count; ++k) {
        const Vec3 point = origin + direction * found.t[k];
        if (point.length() > 1e6) continue;
        for (int axis = 0; axis < 3; ++axis) {
          ASSERT_GE(point[axis], box.min[axis] - 1e-12 * (1 + point.length()));
          ASSERT_LE(point[axis], box.max[axis] + 1e-12 * (1 + point.length()));
        }
      }
    }
  }
}

/// Rays from a crossing of a random line: inwards, outwards, grazing.
void expect_no_acne_and_no_leak(SolidKind kind, int wanted, unsigned seed) {
  Random random(seed);
  int starts = 0, undecided = 0;
  for (int turn = 0; starts < wanted && turn < 20 * wanted; ++turn) {
    const WholeSolid whole = random_whole(random, kind);
    const Vec3 line = random.direction(), from = random.in_cube(1) - line * 4;
    const Crossings first = crossings(whole.solid, from, line, kNoPart, whole.details);
    int k = 0;
    while (k < first.count && !(first.t[k] > 0 && first.t[k] < 8)) ++k;
    if (k == first.count) continue;
    const Vec3 point = from + line * first.t[k];
    const Vec3 normal = normal_at(whole.solid, first.part[k], point, whole.details);
    const Vec3 across = normal.cross(random.direction());
    if (!(across.length() > 0.1)) continue;
    const double lean = (random.uniform(0, 1) < 0.5 ? -1 : 1) * std::pow(10, random.uniform(-6, 0));
    const Vec3 direction = (across.normalized() + normal * lean).normalized();
    const Crossings found = crossings(whole.solid, point, direction, first.part[k], whole.details);
    // Well beyond the start the crossings and the definition agree about the side, whichever way the surface bends.
    ++starts;
    for (int i = 0; i < 8; ++i) {
      const double t = std::pow(10, random.uniform(-5, 0.5));
      const RealVec p = along(point, direction, t);
      const Real value = membership(whole, p);
      if (std::abs(value) <= value_of_shift(whole, p, 1e-12L)) {
        ++undecided;
        continue;
      }
      ASSERT_EQ(inside_at(found, t), value < 0)
          << "kind " << static_cast<int>(kind) << " lean " << lean << " t " << t << " radii " << whole.solid.radius_a
          << " " << whole.solid.radius_b << " value " << static_cast<double>(value);
    }
  }
  EXPECT_EQ(starts, wanted);
  EXPECT_LT(undecided, wanted);
}

TEST(RaysFromASurface, of_a_box_keep_their_side) { expect_no_acne_and_no_leak(SolidKind::box, 10000, 41); }
TEST(RaysFromASurface, of_a_torus_keep_their_side) { expect_no_acne_and_no_leak(SolidKind::torus, 10000, 42); }
TEST(RaysFromASurface, of_a_superellipsoid_keep_their_side) {
  expect_no_acne_and_no_leak(SolidKind::superellipsoid, 10000, 43);
}
TEST(RaysFromASurface, of_an_ovus_keep_their_side) { expect_no_acne_and_no_leak(SolidKind::ovus, 10000, 48); }
TEST(RaysFromASurface, of_a_quadric_keep_their_side) { expect_no_acne_and_no_leak(SolidKind::quadric, 10000, 44); }
TEST(RaysFromASurface, of_a_cubic_keep_their_side) { expect_no_acne_and_no_leak(SolidKind::cubic, 10000, 45); }
TEST(RaysFromASurface, of_a_quartic_keep_their_side) { expect_no_acne_and_no_leak(SolidKind::quartic, 10000, 46); }
TEST(RaysFromASurface, of_a_polynomial_keep_their_side) { expect_no_acne_and_no_leak(SolidKind::poly, 10000, 47); }

TEST(Spindle, is_met_along_its_axis_and_nowhere_within) {
  scene::Solid torus;
  torus.kind = SolidKind::torus;
  torus.radius_a = 0.5;
  torus.radius_b = 1;
  const Crossings found = crossings(torus, {0, 5, 0}, {0, -1, 0}, kNoPart);
  ASSERT_EQ(found.count, 2);
  EXPECT_NEAR(found.t[0], 5 - std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(found.t[1], 5 + std::sqrt(0.75), 1e-12);
}

scene::Solid superellipsoid(double e, double n) {
  scene::Solid solid;
  solid.kind = SolidKind::superellipsoid;
  solid.radius_a = e;
  solid.radius_b = n;
  return solid;
}

TEST(Superellipsoid, poles_are_met_along_the_axes) {
  for (const double e : {0.05, 0.3, 1.0, 2.0, 3.0}) {
    for (const double n : {0.05, 0.3, 1.0, 2.0, 3.0}) {
      for (int axis = 0; axis < 3; ++axis) {
        const scene::Solid solid = superellipsoid(e, n);
        Vec3 direction(0);
        direction[axis] = 1;
        const Crossings found = crossings(solid, direction * -3, direction, kNoPart);
        ASSERT_EQ(found.count, 2) << e << " " << n << " " << axis;
        EXPECT_NEAR(found.t[0], 2, 1e-12);
        EXPECT_NEAR(found.t[1], 4, 1e-12);
      }
    }
  }
}

TEST(Superellipsoid, lets_lines_go_that_lie_in_its_even_sides) {
  // On such a line F is within its rounding nearly all the way, and no halving of it would tell more. A crossing may be
  // found where it is left, but in pairs.
  const scene::Solid can = superellipsoid(1, 0.01), block = superellipsoid(0.01, 0.01);
  for (const std::uint32_t start : {kNoPart, 0U}) {  // from far away, and from its only surface
    const double from = start == kNoPart ? -5 : 0;
    EXPECT_EQ(crossings(can, {1, 0, from}, {0, 0, 1}, start).count % 2, 0);
    EXPECT_EQ(crossings(can, {0.6, 0.8, from}, {0, 0, 1}, start).count % 2, 0);
    EXPECT_EQ(crossings(block, {1, 0.3, from}, {0, 0, 1}, start).count % 2, 0);
    EXPECT_EQ(crossings(block, {from, 1, 0.2}, {1, 0, 1e-4}, start).count % 2, 0);
    EXPECT_EQ(crossings(block, {1 - 1e-15, 0.3, from}, {0, 0.01, 1}, start).count % 2, 0);
  }
}

TEST(Superellipsoid, comes_to_an_end_where_numbers_overflow) {
  const scene::Solid solid = superellipsoid(0.25, 0.25);
  for (const double huge : {1e100, 1e200, 1e300}) {
    for (const double tiny : {1 / huge, 1e-308, 1e-320}) {
      EXPECT_LE(crossings(solid, {-0.5, -0.25, -0.125}, {tiny, huge, 0.3 * huge}, kNoPart).count, 2);
      EXPECT_LE(crossings(solid, {huge, -0.25, tiny}, {-huge, tiny, 0.1}, kNoPart).count, 2);
      EXPECT_LE(crossings(solid, {tiny, -tiny, 0.5}, {tiny, tiny, tiny}, kNoPart).count, 2);
    }
  }
}

}  // namespace
}  // namespace isl::render::test
