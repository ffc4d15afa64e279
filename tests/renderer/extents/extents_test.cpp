// Extents, compared with points of the surfaces and with the extents that POV-Ray 3.7 prints.
#include "renderer/extents/extents.h"

#include "renderer/solids/solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace isl::render {
namespace {

using scene::Database;
using scene::Object;
using scene::Operation;
using scene::Solid;
using scene::SolidKind;
using scene::Vec3;

constexpr double kFar = std::numeric_limits<double>::infinity();

void expect_box(const Box& box, const Vec3& low, const Vec3& high) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(box.min[i], low[i], 5e-5) << "axis " << i;
    EXPECT_NEAR(box.max[i], high[i], 5e-5) << "axis " << i;
  }
}

/// A rotation about z by an angle in degrees.
scene::Transform turned(double degrees) {
  const double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
  scene::Transform t;
  t.matrix = scene::Matrix(c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
  t.inverse = t.matrix.transposed();
  return t;
}

Box box_of_solid(const Solid& solid, const scene::Transform& transform = {}, const Database& database = {}) {
  return box_of(database, solid, transform);
}

TEST(SolidExtent, OfTurnedSolidsIsTight) {
  expect_box(box_of_solid({.radius_a = 1}, turned(45)), Vec3(-1), Vec3(1));
  // POV-Ray prints <-1.3660, -0.5, -1>, <0.8660, 1.3660, 1>, the box of the turned box; ours follows the discs.
  const double r = std::cos(std::numbers::pi / 6);
  expect_box(box_of_solid({.kind = SolidKind::cylinder, .b = {0, 1, 0}, .radius_a = 1}, turned(30)),
             {-r - 0.5, -0.5, -1}, {r, r + 0.5, 1});
  // POV-Ray prints ±<1.2075, 0.8415, 1.25>.
  const Vec3 torus(r + 0.25, 0.5 + 0.25, 1.25);
  expect_box(box_of_solid({.kind = SolidKind::torus, .radius_a = 1, .radius_b = 0.25}, turned(30)), -torus, torus);
  expect_box(box_of_solid({.kind = SolidKind::box, .a = Vec3(-1), .b = Vec3(1)}, turned(45)),
             {-std::sqrt(2), -std::sqrt(2), -1}, {std::sqrt(2), std::sqrt(2), 1});
}

TEST(SolidExtent, OfSlantedCapsIsThatOfTheirDiscs) {
  const double reach = std::sqrt(0.5);  // extent of a unit disc perpendicular to <1, 1, 0>
  expect_box(box_of_solid({.kind = SolidKind::cylinder, .b = {1, 1, 0}, .radius_a = 1}), {-reach, -reach, -1},
             {1 + reach, 1 + reach, 1});
  expect_box(box_of_solid({.kind = SolidKind::disc, .b = Vec3(1, 1, 0).normalized(), .radius_a = 1}),
             {-reach, -reach, -1}, {reach, reach, 1});
}

TEST(SolidExtent, OfAnEllipsoidIsExactAndOfOtherQuadricsEndless) {
  Database database;
  database.polynomials = {{2, {1, 0, 0, -2, 4, 0, 0, 9, 0, 0}}, {2, {1, 0, 0, 0, 1, 0, 0, 0, 0, -1}}};
  const Solid ellipsoid{.kind = SolidKind::quadric, .detail = 0}, tube{.kind = SolidKind::quadric, .detail = 1};
  expect_box(box_of(database, ellipsoid, {}), {0, -0.5, -1.0 / 3}, {2, 0.5, 1.0 / 3});  // as POV-Ray prints it
  EXPECT_FALSE(is_finite(box_of(database, tube, {})));
}

TEST(SolidExtent, OfASuperellipsoidHoldsItsSurfaceAndTouchesIt) {
  for (const auto& [e, n] : {std::pair(0.3, 0.3), std::pair(1.0, 1.0), std::pair(0.5, 2.0), std::pair(3.0, 0.7)}) {
    const Solid solid{.kind = SolidKind::superellipsoid, .radius_a = e, .radius_b = n};
    const Box box = box_of_solid(solid, turned(30));
    double reached = 0;
    for (int i = 0; i < 200; ++i) {
      for (int j = 0; j < 200; ++j) {
        // The usual parametrisation by powers of sines and cosines.
        const double u = i * std::numbers::pi / 199 - std::numbers::pi / 2, v = j * std::numbers::pi / 99.5;
        const auto power = [](double x, double exponent) { return std::copysign(std::pow(std::abs(x), exponent), x); };
        const double ring = power(std::cos(u), n);
        const Vec3 p(ring * power(std::cos(v), e), ring * power(std::sin(v), e), power(std::sin(u), n));
        const Vec3 world = turned(30).point(p);
        for (int axis = 0; axis < 3; ++axis) {
          EXPECT_LE(world[axis], box.max[axis] + 1e-12);
          EXPECT_GE(world[axis], box.min[axis] - 1e-12);
        }
        reached = std::max(reached, world.x / box.max.x);
      }
    }
    EXPECT_GT(reached, 0.99) << e << ' ' << n;
  }
}

TEST(BlobExtent, OfASheetEndsAtItsSurfacesAndNowhereElse) {
  Database database;
  database.kernels.push_back({scene::KernelShape::quartic, scene::RadiusMeaning::surface, 4, scene::FieldMode::sheet});
  scene::Blob& blob = database.blobs.emplace_back();
  blob.components = {{.a = {0, 2, 0}, .b = {0, 1, 0}, .radius_a = 0.5, .skeleton = scene::Skeleton::sheet}};
  scene::Object object;
  object.kind = scene::Object::Kind::blob;
  object.shape = 0;
  const Box box = Extents(database).of(object);
  EXPECT_NEAR(box.min.y, 1.5, 1e-6);
  EXPECT_NEAR(box.max.y, 2.5, 1e-6);
  for (const int axis : {0, 2}) {
    EXPECT_EQ(box.min[axis], -kFar);
    EXPECT_EQ(box.max[axis], kFar);
  }
}

class GroupExtent : public testing::Test {
 protected:
  std::uint32_t add(const Solid& solid) {
    database_.solids.push_back(solid);
    return static_cast<std::uint32_t>(database_.solids.size() - 1);
  }
  static Object solid(std::uint32_t shape, bool inverse = false) {
    Object object;
    object.shape = shape;
    object.inverse = inverse;
    return object;
  }
  Object group(Operation operation, std::vector<Object> children) {
    database_.groups.push_back({.operation = operation, .children = std::move(children)});
    Object object;
    object.kind = Object::Kind::group;
    object.shape = static_cast<std::uint32_t>(database_.groups.size() - 1);
    return object;
  }
  [[nodiscard]] Box of(const Object& object) const { return Extents(database_).of(object); }

  Database database_;
  const std::uint32_t ball_ = add({.radius_a = 1});
  const std::uint32_t box_ = add({.kind = SolidKind::box, .a = Vec3(0), .b = Vec3(2)});
  const std::uint32_t floor_ = add({.kind = SolidKind::plane, .a = {0, 1, 0}});
};

TEST_F(GroupExtent, OfCsgIsWhatTheOperationLeaves) {
  expect_box(of(group(Operation::unite, {solid(ball_), solid(box_)})), Vec3(-1), Vec3(2));
  expect_box(of(group(Operation::intersect, {solid(ball_), solid(box_)})), Vec3(0), Vec3(1));
  expect_box(of(group(Operation::subtract, {solid(ball_), solid(box_)})), Vec3(-1), Vec3(1));
  expect_box(of(group(Operation::intersect, {solid(ball_), solid(floor_)})), Vec3(-1), {1, 0, 1});
  expect_box(of(group(Operation::intersect, {solid(ball_), solid(box_, /*inverse=*/true)})), Vec3(-1), Vec3(1));
  EXPECT_TRUE(of(group(Operation::unite, {})).isEmpty());
}

TEST_F(GroupExtent, OfAnIntersectionOfWhatIsOutsideIsThatOfTheSurfaces) {
  expect_box(of(group(Operation::intersect, {solid(ball_, true), solid(box_, true)})), Vec3(-1), Vec3(2));
}

TEST_F(GroupExtent, OfAHalfSpaceEndsAtItsPlane) {
  const Box box = of(solid(floor_));
  EXPECT_EQ(box.max, Vec3(kFar, 0, kFar));
  EXPECT_EQ(box.min, Vec3(-kFar));
  EXPECT_FALSE(is_finite(of(group(Operation::unite, {solid(ball_), solid(floor_)}))));
}

TEST_F(GroupExtent, OfAClippedObjectEndsWhereItIsClipped) {
  Object clipped = solid(ball_);
  clipped.clip = scene::GroupId{group(Operation::intersect, {solid(floor_)}).shape};
  clipped.parent_from_object.matrix[3][1] = 10;
  expect_box(of(clipped), {-1, 9, -1}, {1, 10, 1});
}

TEST_F(GroupExtent, OfWhatHasNoEndIsWhatBoundsIt) {
  Object bounded = solid(floor_);
  bounded.bound = scene::GroupId{group(Operation::intersect, {solid(box_)}).shape};
  expect_box(of(bounded), Vec3(0), {2, 0, 2});
  Object needless = solid(ball_);
  needless.bound = bounded.bound;
  expect_box(of(needless), Vec3(-1), Vec3(1));
}

TEST_F(GroupExtent, OfAnIntersectionOfPlanesIsThatOfItsCorners) {
  // The half-spaces n·x ≤ |n|; with `subtract` all but the first are what taking away n·x > |n| leaves.
  const auto of_planes = [this](const std::vector<Vec3>& normals, Operation operation = Operation::intersect) {
    std::vector<Object> planes;
    for (const Vec3& n : normals) {
      const double side = operation == Operation::subtract && !planes.empty() ? -1 : 1;
      planes.push_back(solid(add({.kind = SolidKind::plane, .a = n.normalized() * side, .radius_a = side})));
    }
    return of(group(operation, planes));
  };
  // The corners of a tetrahedron around the unit ball are at three times its radius.
  const double corner = std::sqrt(3);
  expect_box(of_planes({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}), Vec3(-corner), Vec3(corner));
  // An octahedron has its corners on the axes.
  expect_box(
      of_planes({{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1}, {-1, 1, 1}, {-1, 1, -1}, {-1, -1, 1}, {-1, -1, -1}}),
      Vec3(-corner), Vec3(corner));
  // Three sides of a tetrahedron leave it open.
  EXPECT_FALSE(is_finite(of_planes({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}})));
  // A column is bounded across only by planes that are parallel to axes.
  const Box column = of_planes({{1, 0, 0}, {-1, 0, 0}, {0, 1, 1}, {0, -1, -1}});
  EXPECT_EQ(column.min, Vec3(-1, -kFar, -kFar));
  EXPECT_EQ(column.max, Vec3(1, kFar, kFar));
  // What is taken away bounds with its other side.
  expect_box(of_planes({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, Operation::subtract), Vec3(-corner),
             Vec3(corner));
}

TEST_F(GroupExtent, OfPlanesHoldsAllTheirPoints) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> even(-1, 1);
  const auto vector = [&] { return Vec3(even(random), even(random), even(random)); };
  int finite = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<Object> planes;
    const Vec3 middle = vector() * 100;
    for (int i = 0; i < 4 + round % 12; ++i) {
      const Vec3 n = vector().normalized();
      Object plane = solid(add({.kind = SolidKind::plane, .a = n, .radius_a = 0.5}), i % 3 == 0);
      if (plane.inverse) database_.solids.back().radius_a = -0.5;
      plane.parent_from_object.matrix.setTranslation(middle);
      plane.parent_from_object.inverse.setTranslation(-middle);
      planes.push_back(plane);
    }
    const Box box = of(group(Operation::intersect, planes));
    finite += is_finite(box) ? 1 : 0;
    // Walks from the middle to the border, in all directions: no such point may be outside the box.
    for (int i = 0; i < 300; ++i) {
      const Vec3 direction = vector();
      double t = kFar;
      for (const Object& plane : planes) {
        const Solid& s = database_.solids[plane.shape];
        const Vec3 n = plane.inverse ? -s.a : s.a;
        if (n.dot(direction) > 0) t = std::min(t, 0.5 / n.dot(direction));
      }
      if (t == kFar) continue;
      const Vec3 point = middle + direction * (t * (1 - 1e-9));
      EXPECT_TRUE(box.intersects(point)) << round;
    }
  }
  EXPECT_GT(finite, 100);
}

TEST_F(GroupExtent, OfAQuadricBetweenPlanesIsFinite) {
  const auto quadric = [this](const std::vector<double>& coefficients) {
    database_.polynomials.push_back({.order = 2, .coefficients = coefficients});
    return solid(
        add({.kind = SolidKind::quadric, .detail = static_cast<std::uint32_t>(database_.polynomials.size() - 1)}));
  };
  const auto below = [this](const Vec3& normal, double distance) {
    return solid(add({.kind = SolidKind::plane, .a = normal, .radius_a = distance}));
  };
  // x² + z² ≤ 4; x² + z² ≤ y²; x² + z² ≤ y; x² + z² ≤ y² + 1; a cylinder about <5, y, -3>.
  const Object cylinder = quadric({1, 0, 0, 0, 0, 0, 0, 1, 0, -4}), cone = quadric({1, 0, 0, 0, -1, 0, 0, 1, 0, 0}),
               paraboloid = quadric({1, 0, 0, 0, 0, 0, -1, 1, 0, 0}),
               hyperboloid = quadric({1, 0, 0, 0, -1, 0, 0, 1, 0, -1});
  Object moved = cylinder;
  moved.parent_from_object.matrix.setTranslation(Vec3(5, 0, -3));
  moved.parent_from_object.inverse.setTranslation(Vec3(-5, 0, 3));
  const Object top = below({0, 1, 0}, 3), bottom = below({0, -1, 0}, 1);
  expect_box(of(group(Operation::intersect, {cylinder, top, bottom})), {-2, -1, -2}, {2, 3, 2});
  expect_box(of(group(Operation::intersect, {top, moved, bottom})), {3, -1, -5}, {7, 3, -1});
  expect_box(of(group(Operation::intersect, {cone, top, bottom})), {-3, -1, -3}, {3, 3, 3});
  expect_box(of(group(Operation::intersect, {paraboloid, top})), {-std::sqrt(3), 0, -std::sqrt(3)},
             {std::sqrt(3), 3, std::sqrt(3)});
  expect_box(of(group(Operation::intersect, {hyperboloid, top, bottom})), {-std::sqrt(10), -1, -std::sqrt(10)},
             {std::sqrt(10), 3, std::sqrt(10)});
  EXPECT_FALSE(is_finite(of(group(Operation::intersect, {cone, top}))));
  Object outside = cylinder;
  outside.inverse = true;
  EXPECT_FALSE(is_finite(of(group(Operation::intersect, {outside, top, bottom}))));
}

TEST_F(GroupExtent, OfQuadricsHoldsAllTheirPoints) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> even(-1, 1);
  const auto vector = [&] { return Vec3(even(random), even(random), even(random)); };
  int narrower = 0, held = 0;
  for (int round = 0; round < 400; ++round) {
    // Half of the quadrics have the axes of space and are bounded across, some without curvature along; a quarter lies
    // far away.
    std::vector<double> c(10);
    for (double& coefficient : c) coefficient = even(random);
    if (round % 2 == 0) {
      c[0] = std::abs(c[0]);
      c[7] = std::abs(c[7]);
      c[1] = c[2] = c[5] = 0;
    }
    if (round % 4 == 0) c[4] = 0;
    c[9] -= 0.5;
    database_.polynomials.push_back({.order = 2, .coefficients = c});
    Object quadric = solid(
        add({.kind = SolidKind::quadric, .detail = static_cast<std::uint32_t>(database_.polynomials.size() - 1)}));
    const Vec3 middle = vector() * (round % 8 < 2 ? 1e6 : 10);
    if (round % 3 == 0) quadric.parent_from_object.inverse.setAxisAngle(vector(), 3 * even(random));
    quadric.parent_from_object.inverse = scene::Matrix().setTranslation(-middle) * quadric.parent_from_object.inverse;
    quadric.parent_from_object.matrix = quadric.parent_from_object.inverse.inverse();
    std::vector<Object> children{quadric};
    for (int i = 0; i < 2; ++i) {
      const double sign = i == 0 ? 1 : -1;
      children.push_back(solid(add({.kind = SolidKind::plane, .a = {0, sign, 0}, .radius_a = sign * middle.y + 1})));
    }
    const Box box = of(group(Operation::intersect, children));
    narrower += std::isfinite(box.max.x) || std::isfinite(box.max.z) ? 1 : 0;
    for (int i = 0; i < 300; ++i) {
      const Vec3 offset = vector() * Vec3(9, 1, 9);
      Vec3 p;
      quadric.parent_from_object.inverse.multVecMatrix(middle + offset, p);
      const double value = c[0] * p.x * p.x + c[1] * p.x * p.y + c[2] * p.x * p.z + c[3] * p.x + c[4] * p.y * p.y +
                           c[5] * p.y * p.z + c[6] * p.y + c[7] * p.z * p.z + c[8] * p.z + c[9];
      if (value > -1e-6) continue;
      ++held;
      EXPECT_TRUE(box.intersects(middle + offset)) << round << " " << offset;
    }
  }
  EXPECT_GT(narrower, 100);
  EXPECT_GT(held, 10000);
}

TEST_F(GroupExtent, FollowsADatabaseThatGrows) {
  Extents extents(database_);
  expect_box(extents.of(group(Operation::unite, {solid(ball_)})), Vec3(-1), Vec3(1));
  expect_box(extents.of(group(Operation::unite, {solid(box_)})), Vec3(0), Vec3(2));
}

}  // namespace
}  // namespace isl::render
