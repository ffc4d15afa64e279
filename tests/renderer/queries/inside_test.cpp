#include "renderer/queries/inside.h"

#include <gtest/gtest.h>

namespace isl::render {
namespace {

using scene::Database;
using scene::Object;
using scene::Operation;
using scene::Solid;
using scene::SolidKind;
using scene::Vec3;

bool holds(const Solid& solid, const Vec3& point) { return is_inside(Database(), solid, point); }

TEST(Inside, OfSurfacesFollowsPovray) {
  EXPECT_FALSE(holds({.radius_a = 1}, {1, 0, 0}));
  EXPECT_FALSE(holds({.kind = SolidKind::cylinder, .b = {0, 1, 0}, .radius_a = 1}, {0, 1, 0}));
  EXPECT_TRUE(holds({.kind = SolidKind::box, .a = Vec3(0), .b = Vec3(1)}, {0, 1, 0}));
  EXPECT_TRUE(holds({.kind = SolidKind::torus, .radius_a = 1, .radius_b = 0.25}, {1.25, 0, 0}));
  EXPECT_TRUE(holds({.kind = SolidKind::plane, .a = {0, 1, 0}}, {3, 0, 4}));
  EXPECT_FALSE(holds({.kind = SolidKind::disc, .b = {0, 1, 0}, .radius_a = 1}, {0, 0, 0}));
}

TEST(Inside, OfEachSolidIsItsDefinition) {
  const Solid cone{.kind = SolidKind::cone, .open = true, .b = {0, 1, 0}, .radius_a = 1};
  EXPECT_TRUE(holds(cone, {0.4, 0.5, 0}));
  EXPECT_FALSE(holds(cone, {0.6, 0.5, 0}));
  EXPECT_FALSE(holds(cone, {0, -0.1, 0}));
  const Solid torus{.kind = SolidKind::torus, .radius_a = 1, .radius_b = 0.25};
  EXPECT_TRUE(holds(torus, {0, 0.2, 1}));
  EXPECT_FALSE(holds(torus, Vec3(0)));
  const Solid disc{.kind = SolidKind::disc, .b = {0, 1, 0}, .radius_a = 1};
  EXPECT_TRUE(holds(disc, {5, -1, 0}));
  EXPECT_FALSE(holds(disc, {0, 1, 0}));
  const Solid rounded{.kind = SolidKind::superellipsoid, .radius_a = 0.3, .radius_b = 0.3};
  EXPECT_TRUE(holds(rounded, Vec3(0.8)));
  EXPECT_FALSE(holds(rounded, Vec3(0.9)));
}

TEST(Inside, OfAPolynomialIsWhereItIsNotPositive) {
  Database database;
  // x² + 2xy + 3z − 4, then x³ + y²z − z − 1; each term tests the place of its coefficient.
  database.polynomials = {{2, {1, 2, 0, 0, 0, 0, 0, 0, 3, -4}},
                          {3, {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, -1, -1}}};
  const Solid quadric{.kind = SolidKind::quadric, .detail = 0}, cubic{.kind = SolidKind::cubic, .detail = 1};
  EXPECT_TRUE(is_inside(database, quadric, {1, 1, 1.0 / 3}));
  EXPECT_FALSE(is_inside(database, quadric, {1, 1, 0.34}));
  EXPECT_TRUE(is_inside(database, cubic, {0, 2, 0.33}));
  EXPECT_FALSE(is_inside(database, cubic, {0, 2, 0.34}));
}

class InsideObject : public testing::Test {
 protected:
  InsideObject() {
    database_.solids = {{.radius_a = 1}, {.a = {1, 0, 0}, .radius_a = 1}};
    for (std::uint32_t i = 0; i < 2; ++i) pair_[i].shape = i;
  }
  [[nodiscard]] bool holds(Operation operation, const Vec3& point) {
    database_.groups = {{.operation = operation, .children = pair_}};
    Object object;
    object.kind = Object::Kind::group;
    object.shape = 0;
    return holds(object, point);
  }
  [[nodiscard]] bool holds(const Object& object, const Vec3& point) {
    StepCounter steps;
    return is_inside(database_, {}, object, point, steps);
  }
  Database database_;
  std::vector<Object> pair_ = std::vector<Object>(2);
};

TEST_F(InsideObject, CombinesAsTheOperationSays) {
  const Vec3 left(-0.5, 0, 0), middle(0.5, 0, 0), right(1.5, 0, 0);
  EXPECT_TRUE(holds(Operation::unite, left) && holds(Operation::unite, right));
  EXPECT_TRUE(holds(Operation::merge, middle) && !holds(Operation::merge, {3, 0, 0}));
  EXPECT_TRUE(holds(Operation::intersect, middle) && !holds(Operation::intersect, left));
  EXPECT_TRUE(holds(Operation::subtract, left) && !holds(Operation::subtract, middle));
  pair_[1].inverse = true;
  EXPECT_TRUE(holds(Operation::intersect, left) && !holds(Operation::intersect, middle));
}

TEST_F(InsideObject, OfATriangleIsNothingInverseOrNot) {
  database_.triangles.resize(1);
  database_.solids[1] = {.kind = SolidKind::triangle, .detail = 0};
  EXPECT_FALSE(holds(Operation::intersect, Vec3(0)));
  EXPECT_FALSE(holds(Operation::subtract, Vec3(0))) << "as in POV-Ray";
  EXPECT_TRUE(holds(Operation::unite, Vec3(0)));
}

TEST_F(InsideObject, FollowsTransformsAndClips) {
  Object object = pair_[0];
  object.parent_from_object.matrix[3][1] = 5;
  object.parent_from_object.inverse[3][1] = -5;
  EXPECT_TRUE(holds(object, {0, 5.5, 0}));
  EXPECT_FALSE(holds(object, Vec3(0)));
  database_.groups = {{.operation = Operation::intersect, .children = {pair_[1]}}};
  object.clip = scene::GroupId{0};
  EXPECT_TRUE(holds(object, {0.5, 5, 0}));
  EXPECT_FALSE(holds(object, {-0.5, 5, 0})) << "clipped away";
}

TEST(Inside, OfABlobIsWhereTheSumReachesTheThreshold) {
  Database database;
  database.kernels.resize(1);
  const std::vector<KernelConstants> kernels{kernel_constants(database.kernels[0])};
  scene::Blob blob{.threshold = 0.25, .components = {}, .origins = {}};
  blob.components = {{.b = {0, 1, 0}, .radius_a = 1, .skeleton = scene::Skeleton::segment}};
  // (1 − q)² = 1/4 at q = 1/2.
  EXPECT_TRUE(is_inside(database, kernels, blob, {0.7071, 0.5, 0}));
  EXPECT_FALSE(is_inside(database, kernels, blob, {0.7072, 0.5, 0}));
  EXPECT_TRUE(is_inside(database, kernels, blob, {0, -0.7071, 0}));
  EXPECT_FALSE(is_inside(database, kernels, blob, {0, 1.7072, 0}));
  blob.components.push_back({.a = {0, 0.5, 0}, .radius_a = 1, .strength = -1});
  EXPECT_FALSE(is_inside(database, kernels, blob, {0, 0.5, 0})) << "carved out";
}

TEST(Inside, OfASheetIsWithinItsRadiusOfThePlane) {
  Database database;
  database.kernels.push_back({scene::KernelShape::cauchy, scene::RadiusMeaning::surface, 4, scene::FieldMode::sheet});
  const std::vector<KernelConstants> kernels{kernel_constants(database.kernels[0])};
  scene::Blob blob{.threshold = 1, .components = {}, .origins = {}};
  blob.components = {{.a = {0, 2, 0}, .b = {0, 1, 0}, .radius_a = 0.5, .skeleton = scene::Skeleton::sheet}};
  for (const double x : {-1e6, 0.0, 3.0}) {
    EXPECT_TRUE(is_inside(database, kernels, blob, {x, 1.5001, 7}));
    EXPECT_TRUE(is_inside(database, kernels, blob, {x, 2.4999, 7}));
    EXPECT_FALSE(is_inside(database, kernels, blob, {x, 1.4999, 7}));
    EXPECT_FALSE(is_inside(database, kernels, blob, {x, 2.5001, 7}));
  }
}

}  // namespace
}  // namespace isl::render
