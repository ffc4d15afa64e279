#include "renderer/queries/object_queries.h"

#include <gtest/gtest.h>

#include <cmath>

namespace isl::render {
namespace {

using scene::Database;
using scene::Object;
using scene::SolidKind;
using scene::TracedPoint;
using scene::Vec3;

Object object(Object::Kind kind, std::uint32_t shape) {
  Object result;
  result.kind = kind;
  result.shape = shape;
  return result;
}

scene::Transform scaled(const Vec3& s) {
  scene::Transform t;
  for (int i = 0; i < 3; ++i) {
    t.matrix[i][i] = s[i];
    t.inverse[i][i] = 1 / s[i];
  }
  return t;
}

void expect_near(const Vec3& found, const Vec3& expected) {
  EXPECT_LT((found - expected).length(), 1e-4) << found << " instead of " << expected;
}

class Trace : public testing::Test {
 protected:
  Trace() { database_.solids = {{.radius_a = 1}, {.kind = SolidKind::torus, .radius_a = 1, .radius_b = 0.2}}; }

  [[nodiscard]] std::optional<TracedPoint> trace(const Object& target, const Vec3& origin, const Vec3& direction) {
    return queries_.trace(database_, target, origin, direction).point;
  }

  Database database_;
  ObjectQueries queries_;
};

TEST_F(Trace, FindsPointAndNormalOfAScaledSphereAsPovrayDoes) {
  Object sphere = object(Object::Kind::solid, 0);
  sphere.parent_from_object = scaled({2, 1, 1});
  const auto hit = trace(sphere, {-5, 0.5, 0}, {3, 0, 0});
  ASSERT_TRUE(hit);
  expect_near(hit->position, {-1.7321, 0.5, 0});
  expect_near(hit->normal, {-0.6547, 0.7559, 0});
}

TEST_F(Trace, MissesBehindItAndWithoutADirection) {
  const Object sphere = object(Object::Kind::solid, 0);
  EXPECT_FALSE(trace(sphere, {0, 0, -5}, {0, 0, -1}));
  EXPECT_FALSE(trace(sphere, {0, 0, -5}, Vec3(0)));
  const auto from_inside = trace(sphere, Vec3(0), {0, 0, 1});
  ASSERT_TRUE(from_inside);
  expect_near(from_inside->position, {0, 0, 1});
  expect_near(from_inside->normal, {0, 0, 1});
}

TEST_F(Trace, TurnsTheNormalOfWhatIsInverseAsPovrayDoes) {
  Object sphere = object(Object::Kind::solid, 0);
  EXPECT_TRUE(trace(sphere, {0, 5, 0}, {0, -1, 0}));
  sphere.inverse = true;
  const auto hit = trace(sphere, {0, 5, 0}, {0, -1, 0});
  ASSERT_TRUE(hit);
  expect_near(hit->position, {0, 1, 0});
  expect_near(hit->normal, {0, -1, 0});
}

TEST_F(Trace, FindsAPlaneThatWasMoved) {
  database_.solids.push_back({.kind = SolidKind::plane, .a = {0, 1, 0}});
  Object plane = object(Object::Kind::solid, 2);
  plane.parent_from_object.matrix[3][1] = -1;
  plane.parent_from_object.inverse[3][1] = 1;
  database_.groups = {{.children = {plane, object(Object::Kind::solid, 0)}}};
  const auto hit = trace(object(Object::Kind::group, 0), {3, 4, 0}, {0, -1, 0});
  ASSERT_TRUE(hit);
  expect_near(hit->position, {3, -1, 0});
}

TEST_F(Trace, SeesWhatFlagsHideFromTheCamera) {
  Object sphere = object(Object::Kind::solid, 0);
  sphere.no_image = sphere.no_shadow = sphere.double_illuminate = true;
  EXPECT_TRUE(trace(sphere, {0, 0, -5}, {0, 0, 1}));
}

TEST_F(Trace, FindsCutSurfacesWithTheirNormalsOutwards) {
  // The numbers are those of POV-Ray.
  database_.solids.push_back({.kind = SolidKind::box, .a = Vec3(-1), .b = Vec3(1)});
  database_.solids.push_back({.a = {0, 1, 0}, .radius_a = 0.5});
  database_.groups = {{.operation = scene::Operation::subtract,
                       .children = {object(Object::Kind::solid, 2), object(Object::Kind::solid, 3)}}};
  const auto hit = trace(object(Object::Kind::group, 0), {0, 5, 0}, {0, -1, 0});
  ASSERT_TRUE(hit);
  expect_near(hit->position, {0, 0.5, 0});
  expect_near(hit->normal, {0, 1, 0});
}

TEST_F(Trace, FollowsADatabaseThatGrows) {
  EXPECT_TRUE(trace(object(Object::Kind::solid, 0), {0, 0, -5}, {0, 0, 1}));
  database_.kernels.resize(1);
  scene::Blob blob;
  blob.threshold = 0.25;
  blob.components = {{.a = {0, 9, 0}, .radius_a = 1}};
  blob.origins.resize(1);
  database_.blobs = {blob};
  Object moved = object(Object::Kind::blob, 0);
  moved.parent_from_object.matrix[3][0] = 3;
  moved.parent_from_object.inverse[3][0] = -3;
  database_.groups = {{.children = {object(Object::Kind::solid, 0), moved}}};
  const auto hit = trace(object(Object::Kind::group, 0), {3, 9, -5}, {0, 0, 1});
  ASSERT_TRUE(hit);
  expect_near(hit->position, {3, 9, -std::sqrt(0.5)});
  expect_near(hit->normal, {0, 0, -1});
}

TEST_F(Trace, PreparesAgainWhatThereIsNoMemoryToKeep) {
  database_.kernels.resize(1);
  for (int copy = 0; copy < 2; ++copy) {
    scene::Blob& blob = database_.blobs.emplace_back();
    blob.threshold = 0.25;
    for (int i = 0; i < 500; ++i) blob.components.push_back({.a = {0.3 * (i % 25), 0.3 * (i / 25), 0}, .radius_a = 1});
    blob.origins.resize(blob.components.size());
  }
  const auto is_answered = [&](ObjectQueries& queries, std::uint32_t blob) {
    const auto answer = queries.trace(database_, object(Object::Kind::blob, blob), {3, 3, -5}, {0, 0, 1});
    return !queries.refusal() && answer.point.has_value();
  };
  // The least memory for one of them.
  std::size_t limit = 100'000;
  while (true) {
    Budget budget(limit);
    RunLimits run;
    run.budget = &budget;
    ObjectQueries queries(run);
    if (is_answered(queries, 0)) break;
    EXPECT_TRUE(queries.refusal());
    limit += limit / 16;
  }
  Budget budget(limit);
  RunLimits run;
  run.budget = &budget;
  ObjectQueries queries(run);
  for (std::uint32_t i = 0; i < 4; ++i) EXPECT_TRUE(is_answered(queries, i % 2)) << i;
}

}  // namespace
}  // namespace isl::render
