// The surfaces that a combination shows, with their textures and normals: open surfaces, open tubes, clips, unions
// within.
#include "tests/renderer/csg/csg_scene.h"

#include <gtest/gtest.h>

namespace isl::render::test {
namespace {

scene::Solid disc(const Vec3& centre, double radius) {
  scene::Solid solid;
  solid.kind = scene::SolidKind::disc;
  solid.a = centre;
  solid.b = {0, 1, 0};
  solid.radius_a = radius;
  return solid;
}

class Surfaces : public testing::Test {
 protected:
  /// The heights at which a line down meets the object.
  [[nodiscard]] std::vector<double> heights(const Object& object, double x, double from = 5) {
    scene_.database.objects = {object};
    const Tracer tracer(scene_.database, {});
    std::vector<double> result;
    for (const double t : walk(tracer, {x, from, 0}, {0, -1, 0}).t) result.push_back(from - t);
    return result;
  }
  /// Texture and normal of the first surface on the way down.
  [[nodiscard]] SurfacePoint seen(const Object& object, double x, double from = 5) {
    scene_.database.objects = {object};
    const Tracer tracer(scene_.database, {});
    const Walk found = walk(tracer, {x, from, 0}, {0, -1, 0}, 1);
    SurfacePoint point;
    if (found.t.empty()) return point;
    const Ray ray{{x, from, 0}, {0, -1, 0}, std::numeric_limits<double>::infinity(), 0, {}};
    tracer.surface_at(ray, found.hits[0], point);
    return point;
  }
  Object triangle(double height) {
    scene::Triangle triangle;
    triangle.normals.fill({0, 1, 0});
    triangle.corners = {Vec3(-5, height, -5), Vec3(5, height, -5), Vec3(0, height, 5)};
    scene_.database.triangles.push_back(triangle);
    scene::Solid solid;
    solid.kind = scene::SolidKind::triangle;
    solid.detail = static_cast<std::uint32_t>(scene_.database.triangles.size() - 1);
    return scene_.solid(solid);
  }
  static void expect_heights(const std::vector<double>& found, const std::vector<double>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-12);
  }

  CsgScene scene_;
};

TEST_F(Surfaces, OfSheetsAreCutAndCutNothingAsInPovray) {
  const Object ball = scene_.solid(sphere(Vec3(0), 1));
  expect_heights(heights(scene_.group(Operation::intersect, {ball, triangle(0.5)}), 0), {0.5});
  expect_heights(heights(scene_.group(Operation::intersect, {ball, triangle(0.5)}), 2), {});
  expect_heights(heights(scene_.group(Operation::subtract, {ball, triangle(0.5)}), 0), {0.5});
  expect_heights(heights(scene_.group(Operation::merge, {ball, triangle(0.5)}), 0), {1, -1});
  expect_heights(heights(scene_.group(Operation::merge, {ball, triangle(0.5)}), 2), {0.5});
}

TEST_F(Surfaces, OfADiscEndAtItsRimAndItsInsideDoesNot) {
  const Object ball = scene_.solid(sphere(Vec3(0), 1));
  const double rim = std::sqrt(0.75);
  expect_heights(heights(scene_.group(Operation::intersect, {ball, scene_.solid(disc({0, 0.5, 0}, 0.2))}), 0),
                 {0.5, -1});
  expect_heights(heights(scene_.group(Operation::intersect, {ball, scene_.solid(disc({0, 0.5, 0}, 0.2))}), 0.5),
                 {-rim});
  expect_heights(heights(scene_.group(Operation::subtract, {ball, scene_.solid(disc({0, 0.5, 0}, 0.2))}), 0), {1, 0.5});
}

TEST_F(Surfaces, OfAnOpenTubeAreItsSide) {
  scene::Solid tube;
  tube.kind = scene::SolidKind::cylinder;
  tube.a = {0, -0.5, 0};
  tube.b = {0, 0.5, 0};
  tube.radius_a = 0.3;
  tube.open = true;
  const Object both = scene_.group(Operation::intersect, {scene_.solid(sphere(Vec3(0), 1)), scene_.solid(tube)});
  expect_heights(heights(both, 0), {});
  const Object cut = scene_.group(Operation::subtract, {scene_.solid(sphere(Vec3(0), 1)), scene_.solid(tube)});
  expect_heights(heights(cut, 0), {1, -1});
}

TEST_F(Surfaces, OfWhatIsClippedStayWhereTheClipIsAndGetNoCap) {
  const Object ball = scene_.solid(sphere(Vec3(0), 1));
  const Object half = scene_.clipped(ball, {scene_.solid(plane({0, 1, 0}, 0.3))});
  expect_heights(heights(half, 0), {-1});
  expect_heights(heights(half, 0.99), {std::sqrt(1 - 0.99 * 0.99), -std::sqrt(1 - 0.99 * 0.99)});
  // Within a combination a clip also removes the inside.
  const Object cut = scene_.group(Operation::subtract, {scene_.solid(box(Vec3(-2), Vec3(2))), half});
  expect_heights(heights(cut, 0), {2, -1, -2});
}

TEST_F(Surfaces, WithinAUnionStayAndWithinAMergeGo) {
  const std::vector<Object> balls = {scene_.solid(sphere(Vec3(0), 1)), scene_.solid(sphere({0, 0.5, 0}, 1))};
  const Object room = scene_.solid(box(Vec3(-5), Vec3(4)));
  const auto within = [&](Operation operation) {
    return scene_.group(Operation::intersect, {scene_.group(operation, balls), room});
  };
  expect_heights(heights(within(Operation::unite), 0), {1.5, 1, -0.5, -1});
  expect_heights(heights(within(Operation::merge), 0), {1.5, -1});
}

TEST_F(Surfaces, StayWhereABlobHoldsTheWholeRay) {
  scene::Component half_space;
  half_space.skeleton = scene::Skeleton::plane;
  half_space.a = {0, 5, 0};
  half_space.b = {0, 1, 0};
  half_space.radius_a = 0.1;
  const Object all = scene_.blob({half_space}, 0.5), block = scene_.solid(box(Vec3(-1), Vec3(1)));
  expect_heights(heights(scene_.group(Operation::intersect, {all, block}), 0, 4), {1, -1});
  expect_heights(heights(scene_.group(Operation::subtract, {all, block}), 0, 4), {1, -1});
  expect_heights(heights(scene_.group(Operation::subtract, {block, all}), 0, 4), {});
}

TEST_F(Surfaces, OfADifferenceHaveTheTextureOfWhatWasTakenAway) {
  scene_.database.textures.resize(6);
  Object ball = scene_.solid(sphere({0, 1, 0}, 0.5));
  const Object block = scene_.solid(box(Vec3(-1), Vec3(1)));
  Object plain = scene_.group(Operation::subtract, {block, ball});
  plain.texture = scene::TextureId{3};
  EXPECT_EQ(seen(plain, 0).textures[0].texture, scene::TextureId{3})
      << "the texture of the whole, if the part has none";
  EXPECT_EQ(seen(plain, 0).normal, Vec3(0, 1, 0));
  ball.texture = scene::TextureId{4};
  Object cut = scene_.group(Operation::subtract, {block, ball});
  cut.texture = scene::TextureId{3};
  EXPECT_EQ(seen(cut, 0).textures[0].texture, scene::TextureId{4});
  EXPECT_EQ(seen(cut, 0.9).textures[0].texture, scene::TextureId{3});
  Object within = scene_.group(Operation::merge, {scene_.solid(sphere({0, -3, 0}, 0.1)), cut});
  within.texture = scene::TextureId{5};
  EXPECT_EQ(seen(within, 0.9).textures[0].texture, scene::TextureId{3});
}

TEST_F(Surfaces, CutAwayLookLikeWhatTheyWereCutFromIfTheSceneSaysSo) {
  scene_.database.textures.resize(6);
  Object left = scene_.solid(box({-1, -1, -1}, {0, 1, 1})), right = scene_.solid(box({0, -1, -1}, {1, 1, 1}));
  left.texture = scene::TextureId{1};
  right.texture = scene::TextureId{2};
  const Object both = scene_.group(Operation::merge, {left, right});
  const Object cut = scene_.group(Operation::subtract, {both, scene_.solid(plane({0, -1, 0}, 0))});
  EXPECT_EQ(seen(cut, 0.5).textures[0].texture, scene::kNoTexture);
  scene_.database.groups[cut.shape].cutaway_textures = true;
  EXPECT_EQ(seen(cut, 0.5).position.y, 0);
  EXPECT_EQ(seen(cut, 0.5).textures[0].texture, scene::TextureId{2});
  EXPECT_EQ(seen(cut, -0.5).textures[0].texture, scene::TextureId{1});
}

TEST_F(Surfaces, OfCopiesComeFromOneTree) {
  const Object cut =
      scene_.group(Operation::subtract, {scene_.solid(box(Vec3(-1), Vec3(1))), scene_.solid(sphere({0, 1, 0}, 0.5))});
  Object moved = cut;
  scene::Matrix shift;
  shift.setTranslation(Vec3(5, 2, 0));
  moved.parent_from_object = affine(shift);
  scene_.database.objects = {cut, moved};
  const Tracer both(scene_.database, {});
  expect_heights({5 - walk(both, {5, 5, 0}, {0, -1, 0}).t[0]}, {2.5});
  const std::size_t bytes = both.grid_bytes();
  scene_.database.objects = {cut};
  const Tracer one(scene_.database, {});
  EXPECT_LT(bytes, 2 * one.grid_bytes());
}

TEST_F(Surfaces, OfCombinationsAreBoundedByTheirOperations) {
  // In a grid of many objects, an intersection with planes is found at its place.
  Object wedge =
      scene_.group(Operation::intersect, {scene_.solid(sphere({50, 0, 0}, 1)), scene_.solid(plane({0, 1, 0}, 0))});
  scene_.database.objects = {wedge};
  for (int i = 0; i < 10; ++i) scene_.database.objects.push_back(scene_.solid(sphere({3.0 * i, 0, 0}, 1)));
  const Tracer tracer(scene_.database, {});
  expect_heights({5 - walk(tracer, {50, 5, 0}, {0, -1, 0}).t[0]}, {0});
  EXPECT_NE(tracer.grid_json().find("\"listed\": 0"), std::string::npos);
}

}  // namespace
}  // namespace isl::render::test
