// The result of a texture at a point: layers as in POV-Ray 3.7, and the textures that patterns choose.
#include "renderer/shading/point_textures.h"

#include "renderer/shading/lighting.h"
#include "tests/renderer/shading/lit_point.h"
#include "tests/support/patterns.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <vector>

namespace isl::render::test {
namespace {

using scene::TextureId;

/// Adds layers, the lowest first. Returns the index of the topmost.
TextureId add_layers(scene::Database& database, const std::vector<scene::Colour>& colours,
                     const scene::Finish& finish) {
  TextureId below = scene::kNoTexture;
  for (const scene::Colour& colour : colours) {
    scene::Texture layer = isl::test::plain_texture(database, colour, finish);
    layer.below = below;
    below = TextureId{static_cast<std::uint32_t>(database.textures.size())};
    database.textures.push_back(layer);
  }
  return below;
}

/// The point (x, 0, 0) of `plane { z, 0 }`, seen from in front.
class Point {
 public:
  Point(const scene::Database& database, TextureId texture, const Vec3& position = {0, 0, 0})
      : textures_(database), shading_(position, {0, 0, -1}, {0, 0, 1}) {
    SurfacePoint point;
    point.position = position;
    point.textures = {{texture, 1, position}};
    Charge charge;
    EXPECT_TRUE(textures_.append(point, lit_, charge));
    shading_.textures = lit_;
  }
  [[nodiscard]] const std::vector<LitTexture>& lit() const { return lit_; }
  [[nodiscard]] const ShadingPoint& shading() const { return shading_; }

 private:
  PointTextures textures_;
  std::vector<LitTexture> lit_;
  ShadingPoint shading_;
};

void expect_point_colour(const Rgb& colour, double red, double green, double blue) {
  EXPECT_NEAR(colour.x, red, 1e-4);
  EXPECT_NEAR(colour.y, green, 1e-4);
  EXPECT_NEAR(colour.z, blue, 1e-4);
}

constexpr scene::Colour kBase{0.8, 0.7, 0.6};

// POV-Ray's numbers for plane { z, 0 texture { pigment { rgb <.8, .7, .6> } } … } and `finish { ambient 1 diffuse 0 }`.
TEST(PointTextures, LayersLetLightThroughAsPovraysDo) {
  const auto shown = [](const std::vector<scene::Colour>& above) {
    scene::Database database;
    std::vector<scene::Colour> colours{kBase};
    colours.insert(colours.end(), above.begin(), above.end());
    const TextureId top = add_layers(database, colours, {.ambient = {1, 1, 1}, .diffuse = 0});
    return ambient_colour(Point(database, top).shading());
  };
  expect_point_colour(shown({{1, 0.5, 0.25, 0.5, 0}}), 0.9, 0.425, 0.2);
  expect_point_colour(shown({{1, 0.5, 0.25, 0, 0.5}}), 0.9, 0.6, 0.425);
  expect_point_colour(shown({{1, 0.5, 0.25, 0.3, 0.4}}), 0.86, 0.535, 0.36);
  expect_point_colour(shown({{0.9, 0.5, 0.25, 0.5, 0}, {0.6, 0.5, 0.9, 0.7, 0}}), 0.5202, 0.2988, 0.396);
  expect_point_colour(shown({{0.9, 0.5, 0.25, 0.5, 0.2}, {0.6, 0.5, 0.9, 0.3, 0.4}}), 0.6382, 0.4058, 0.4509);
  expect_point_colour(shown({{0.9, 0.5, 0.25, 0.5, 0.8}}), 0.73, 0.585, 0.48);
}

// The same layers with light_source { <2, 3, -10> rgb <1, .9, .8> } and `finish { ambient 0 diffuse .5 phong .4
// phong_size 2 }`, at the middle of the first of 2x2 pixels that show 0.1 × 0.1.
TEST(PointTextures, HighlightsOfLayersAreAddedUp) {
  const auto lit = [](const std::vector<scene::Colour>& above) {
    scene::Database database;
    std::vector<scene::Colour> colours{kBase};
    colours.insert(colours.end(), above.begin(), above.end());
    const scene::Finish finish{.ambient = {0, 0, 0}, .diffuse = 0.5, .phong = 0.4, .phong_size = 2};
    const TextureId top = add_layers(database, colours, finish);
    scene::Light light;
    light.location = {2, 3, -10};
    light.colour = {1, 0.9, 0.8};
    return lit_by(light, Point(database, top, {-0.025, 0.025, 0}).shading());
  };
  expect_point_colour(lit({}), 0.7305, 0.6151, 0.5091);
  expect_point_colour(lit({{1, 0.5, 0.25, 0.5, 0}}), 0.9546, 0.5783, 0.394);
  EXPECT_NEAR(lit({{0.9, 0.5, 0.25, 0.5, 0}, {1, 0.5, 0.25, 0, 0.6}}).y, 0.7504, 1e-4);
}

TEST(PointTextures, NothingBelowAnOpaqueLayerIsLookedAt) {
  scene::Database database;
  EXPECT_EQ(Point(database, add_layers(database, {kBase, {1, 0, 0}}, {})).lit().size(), 1u);
}

/// Texture 2 chooses between the first two, red and blue.
scene::Database with_choice(scene::Pattern pattern, double first, double second) {
  scene::Database database;
  database.textures = {{.pigment = {{1, 0, 0}}}, {.pigment = {{0, 0, 1}}}, {.pattern = scene::TexturePatternId{0}}};
  database.texture_maps = {{{first, TextureId{0}}, {second, TextureId{1}}}};
  database.texture_patterns.push_back({std::move(pattern), scene::TextureMapId{0}});
  return database;
}

TEST(PointTextures, BetweenTwoEntriesOfAMapTexturesAreBlended) {
  const scene::Database database = with_choice(gradient_along({1, 0, 0}), 0.25, 0.75);
  const Point point(database, TextureId{2}, {0.375, 0, 0});
  ASSERT_EQ(point.lit().size(), 2u);
  EXPECT_EQ(point.lit()[0].weight, 0.75);
  EXPECT_EQ(point.lit()[1].weight, 0.25);
  EXPECT_EQ(point.lit()[1].pigment, Rgb(0, 0, 1));
  EXPECT_EQ(Point(database, TextureId{2}, {0.125, 0, 0}).lit().size(), 1u);
}

TEST(PointTextures, AnAverageIsWeighted) {
  const scene::Database database = with_choice(pattern_of(scene::PatternKind::average), 1, 3);
  const Point point(database, TextureId{2});
  ASSERT_EQ(point.lit().size(), 2u);
  EXPECT_EQ(point.lit()[0].weight, 0.25);
  EXPECT_EQ(point.lit()[1].weight, 0.75);
}

TEST(PointTextures, AnObjectChoosesByItsInside) {
  scene::Database database = with_choice(pattern_of(scene::PatternKind::object, scene::ObjectOperands{0}), 0, 1);
  database.solids.push_back({.kind = scene::SolidKind::sphere, .a = {1, 0, 0}, .radius_a = 0.5});
  database.pattern_objects.push_back({.shape = 0});
  EXPECT_EQ(Point(database, TextureId{2}, {1.2, 0, 0}).lit().front().pigment, Rgb(0, 0, 1));
  EXPECT_EQ(Point(database, TextureId{2}, {0.2, 0, 0}).lit().front().pigment, Rgb(1, 0, 0));
}

TEST(PointTextures, WhatAPatternChoosesLiesInThePatternsSpace) {
  // The pattern is twice as large, and so is the gradient in the texture that it chooses.
  scene::Pattern checker = pattern_of(scene::PatternKind::checker);
  checker.warps.emplace_back(scene::TransformId{0});
  scene::Database database = with_choice(checker, 0, 1);
  scene::Transform twice;
  twice.matrix.setScale(Vec3(2));
  twice.inverse.setScale(Vec3(0.5));
  database.transforms.push_back(twice);
  database.pigments.push_back({.pattern = gradient_along({1, 0, 0}), .map = scene::PigmentMapId{0}});
  database.pigment_maps = {{{0, {}}, {1, {{0, 1, 0}}}}};
  database.textures[0].pigment = database.textures[1].pigment = {.pattern = scene::PigmentId{0}};
  EXPECT_NEAR(Point(database, TextureId{2}, {0.5, 0, 0}).lit().front().pigment.y, 0.25, 1e-6);
}

}  // namespace
}  // namespace isl::render::test
