#include "cli/summary/scene_extent.h"

#include "cli/summary/scene_summary.h"
#include "tests/support/sphereflake.h"

#include <gtest/gtest.h>

namespace isl::cli {
namespace {

using scene::Component;
using scene::Database;
using scene::Object;
using scene::Vec3;

constexpr double kBoxError = 1e-5;  // in radii: where the bisection ends

Database blob_of(const scene::Kernel& kernel, const std::vector<Component>& components, double threshold = 1) {
  Database database;
  database.kernels.push_back(kernel);
  scene::Blob& blob = database.blobs.emplace_back();
  blob.threshold = threshold;
  blob.components = GrowingArray<Component>(components);
  blob.origins.resize(blob.components.size());
  database.objects.push_back({.kind = Object::Kind::blob, .shape = 0});
  return database;
}

constexpr scene::Kernel kGaussian{scene::KernelShape::gaussian, scene::RadiusMeaning::surface, 4};

void expect_near(const Vec3& found, const Vec3& expected) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(found[axis], expected[axis], kBoxError) << "axis " << axis;
}

TEST(SceneExtent, OfALoneComponentIsItsSurface) {
  const SceneExtent extent = extent_of(blob_of(kGaussian, {{.a = {1, 2, 3}, .radius_a = 0.5}}));
  expect_near(extent.box.min, {0.5, 1.5, 2.5});
  expect_near(extent.box.max, {1.5, 2.5, 3.5});
}

TEST(SceneExtent, OfPovraysComponentFollowsTheThreshold) {
  // Strength 1, threshold 0.25: (1 − q)² = 0.25 where q = 1/2.
  const SceneExtent extent = extent_of(blob_of({}, {{.radius_a = 2}}, 0.25));
  expect_near(extent.box.max, Vec3(2 * std::sqrt(0.5)));
}

TEST(SceneExtent, OfALimbReachesFromEndToEnd) {
  const SceneExtent extent = extent_of(
      blob_of(kGaussian,
              {{.a = {0, 0, 0}, .b = {0, 4, 0}, .radius_a = 1, .radius_b = 0.25, .skeleton = scene::Skeleton::cone}}));
  expect_near(extent.box.min, {-1, -1, -1});
  expect_near(extent.box.max, {1, 4.25, 1});
}

TEST(SceneExtent, OfUnionsOfUnionsIsFoundOncePerGroup) {
  // A plane and a ball, then sixty unions of the one before, twice: 2^60 balls at 0, 1, … 60 along x.
  Database database;
  database.solids.resize(2);
  database.solids[0] = {.kind = scene::SolidKind::plane, .a = {0, 1, 0}};
  database.solids[1] = {.kind = scene::SolidKind::sphere, .radius_a = 1};
  const auto object = [](Object::Kind kind, std::uint32_t shape, double x) {
    Object result{.kind = kind, .shape = shape};
    result.parent_from_object.matrix[3][0] = x;
    result.parent_from_object.inverse[3][0] = -x;
    return result;
  };
  database.groups.push_back({.children = {object(Object::Kind::solid, 0, 0), object(Object::Kind::solid, 1, 0)}});
  for (std::uint32_t i = 0; i < 60; ++i) {
    database.groups.push_back({.children = {object(Object::Kind::group, i, 0), object(Object::Kind::group, i, 1)}});
  }
  database.objects.push_back(object(Object::Kind::group, 60, 0));
  const SceneExtent extent = extent_of(database);
  EXPECT_TRUE(extent.unbounded);
  expect_near(extent.box.min, {-1, -1, -1});
  expect_near(extent.box.max, {61, 1, 1});
}

TEST(SceneExtent, HoldsWhatComponentsOnlyReachTogether) {
  // Each component alone has no surface (its strength is below the threshold), but two in the same place have one.
  const Component weak{.radius_a = 1, .strength = 0.02};
  EXPECT_TRUE(extent_of(blob_of(kGaussian, {weak})).box.isEmpty() == false) << "e⁴ · 0.02 exceeds 1";
  const Component too_weak{.radius_a = 1, .strength = 0.01};
  EXPECT_TRUE(extent_of(blob_of(kGaussian, {too_weak})).box.isEmpty());
  EXPECT_FALSE(extent_of(blob_of(kGaussian, {too_weak, too_weak})).box.isEmpty());
}

TEST(SceneExtent, FollowsTransformsOfComponentsAndObjects) {
  Database database = blob_of(kGaussian, {{.radius_a = 1, .transform = scene::TransformId(0)}});
  scene::Matrix stretch;
  stretch.setScale(Vec3(2, 1, 1));
  database.transforms.push_back({stretch, stretch.inverse()});
  scene::Matrix up;
  up.setTranslation(Vec3(0, 10, 0));
  database.objects[0].parent_from_object = {up, up.inverse()};
  const SceneExtent extent = extent_of(database);
  expect_near(extent.box.min, {-2, 9, -1});
  expect_near(extent.box.max, {2, 11, 1});
}

TEST(SceneExtent, HoldsEverySphereOfTheFlakeAndNotMuchMore) {
  const Database database = test::sphereflake(3, kGaussian);
  Imath::Box3d spheres;  // the surfaces of the components alone
  for (const Component& c : database.blobs[0].components) {
    spheres.extendBy(c.a - Vec3(c.radius_a));
    spheres.extendBy(c.a + Vec3(c.radius_a));
  }
  const SceneExtent extent = extent_of(database);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LE(extent.box.min[axis], spheres.min[axis] + kBoxError);
    EXPECT_GE(extent.box.max[axis], spheres.max[axis] - kBoxError);
    EXPECT_LT(extent.box.size()[axis], 1.2 * spheres.size()[axis]) << "blending adds little";
  }
}

TEST(SceneExtent, LeavesPlanesOut) {
  Database database;
  database.solids.push_back({.kind = scene::SolidKind::plane, .a = {0, 1, 0}});
  database.objects.push_back({.shape = 0});
  EXPECT_TRUE(extent_of(database).unbounded);
  EXPECT_TRUE(extent_of(database).box.isEmpty());
}

TEST(SceneExtent, ACameraInFrontSeesAndOneBehindDoesNot) {
  const Imath::Box3d box(Vec3(-1), Vec3(1));
  scene::Camera camera;
  camera.location = {0, 0, -5};
  EXPECT_TRUE(may_see(camera, box));
  camera.location = {0, 0, 5};
  EXPECT_FALSE(may_see(camera, box));
  camera.location = {50, 0, -5};
  EXPECT_FALSE(may_see(camera, box));
}

TEST(SceneSummary, CountsWhatSharedGroupsPlaceWithoutVisitingIt) {
  // Forty groups, each of which places the one before twice, make 2⁴⁰ solids.
  Database database;
  database.solids.push_back({.radius_a = 1});
  database.groups.push_back({.children = {{.shape = 0}}});
  for (std::uint32_t level = 1; level <= 40; ++level) {
    const Object inner{.kind = Object::Kind::group, .shape = level - 1};
    database.groups.push_back({.children = {inner, inner}});
  }
  database.objects.push_back({.kind = Object::Kind::group, .shape = 40});
  EXPECT_EQ(summarise(database).solids, std::uint64_t{1} << 40);
  expect_near(extent_of(database).box.max, Vec3(1));
}

}  // namespace
}  // namespace isl::cli
