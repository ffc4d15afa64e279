// Compilation of a blob's components: canonical order, groups, and transforms that are baked in.
#include "renderer/fields/component_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace isl::render {
namespace {

scene::Database database() {
  scene::Database result;
  result.kernels.push_back({scene::KernelShape::gaussian, scene::RadiusMeaning::surface, 4});
  result.kernels.push_back({scene::KernelShape::quartic, scene::RadiusMeaning::surface, 4});
  return result;
}

scene::Blob mixed_blob() {
  scene::Blob blob;
  for (int i = 0; i < 40; ++i) {
    scene::Component c;
    c.a = Vec3(std::sin(i), std::cos(2.0 * i), 0.1 * i);
    c.b = c.a + Vec3(0, 1, 0);
    c.radius_a = 0.2 + 0.01 * i;
    c.radius_b = 0.1;
    c.kernel = scene::KernelId(i % 2);
    c.skeleton = static_cast<scene::Skeleton>(i % 3);
    c.strength = i == 7 ? 0 : 1;
    blob.components.push_back(c);
    blob.origins.push_back({});
  }
  return blob;
}

TEST(ComponentTable, OrderOfTheSceneDoesNotMatter) {
  const scene::Database db = database();
  scene::Blob blob = mixed_blob();
  const ComponentTable forward = compile_components(db, blob);
  std::reverse(blob.components.begin(), blob.components.end());
  const ComponentTable backward = compile_components(db, blob);
  EXPECT_EQ(forward.x, backward.x);
  EXPECT_EQ(forward.z, backward.z);
  EXPECT_EQ(forward.scale, backward.scale);
  EXPECT_EQ(forward.amplitude, backward.amplitude);
}

TEST(ComponentTable, GroupsHoldOneSkeletonAndOneKernelEach) {
  const ComponentTable table = compile_components(database(), mixed_blob());
  ASSERT_EQ(table.groups.size(), 6U);  // points, segments and cones, each with two kernels
  EXPECT_EQ(table.groups.front().begin, 0U);
  EXPECT_EQ(table.groups.back().end, table.size());
  for (std::size_t i = 1; i < table.groups.size(); ++i) EXPECT_EQ(table.groups[i].begin, table.groups[i - 1].end);
  EXPECT_EQ(&table.group_of(table.groups[2].begin), &table.groups[2]);
}

TEST(ComponentTable, LeavesOutComponentsWithoutStrength) {
  const ComponentTable table = compile_components(database(), mixed_blob());
  EXPECT_EQ(table.size(), 39U);
  EXPECT_EQ(std::count(table.source.begin(), table.source.end(), 7U), 0);
}

TEST(ComponentTable, BakesInSimilaritiesAndKeepsOtherMapsApart) {
  scene::Database db = database();
  scene::Transform similar, uneven;
  similar.matrix = scene::Matrix().rotate(Vec3(0.3, 0.2, 0.1)) * scene::Matrix().setScale(2.0);
  similar.inverse = similar.matrix.inverse();
  uneven.matrix.setScale(Vec3(1, 2, 3));
  uneven.inverse = uneven.matrix.inverse();
  db.transforms = {similar, uneven};
  scene::Blob blob;
  scene::Component c;
  c.a = Vec3(1, 0, 0);
  c.radius_a = 0.5;
  c.transform = scene::TransformId{0};
  blob.components.push_back(c);
  c.transform = scene::TransformId{1};
  blob.components.push_back(c);
  blob.origins.resize(2);
  const ComponentTable table = compile_components(db, blob);
  ASSERT_EQ(table.groups.size(), 2U);
  EXPECT_EQ(table.groups[0].skeleton, scene::Skeleton::point);
  EXPECT_EQ(table.groups[1].skeleton, scene::Skeleton::point);
  EXPECT_TRUE(table.groups[1].is_mapped);
  EXPECT_NEAR(Vec3(table.x[0], table.y[0], table.z[0]).length(), 2, 1e-14);
  EXPECT_NEAR(support_radius(table, table.groups[0], 0), std::sqrt(table.groups[0].kernel.support_q()), 1e-14);
}

TEST(ComponentTable, TrianglesStandInOneOrderHoweverTheyAreNamed) {
  scene::Database db;
  db.kernels.push_back({scene::KernelShape::quartic, scene::RadiusMeaning::surface, 4});
  const auto first_row = [&](const Vec3& p, const Vec3& q) {
    scene::Blob blob;
    blob.corners = {p, q};
    for (const std::uint32_t corner : {0u, 1u}) {
      blob.components.push_back(
          {.b = {1, 0, 0}, .radius_a = 0.1, .skeleton = scene::Skeleton::triangle, .corner = corner});
      blob.origins.push_back({});
    }
    return std::get<std::vector<FlatTriangle>>(compile_components(db, blob).shapes).at(0).corner[2];
  };
  EXPECT_EQ(first_row({0, 1, 0}, {0, 0, 1}), first_row({0, 0, 1}, {0, 1, 0}));
}

}  // namespace
}  // namespace isl::render
