#include "renderer/scene/unrendered.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isl::scene {
namespace {

using testing::ElementsAre;

Object object(Object::Kind kind, std::uint32_t shape, std::uint32_t origin = 0) {
  Object result;
  result.kind = kind;
  result.shape = shape;
  result.origin = {origin};
  return result;
}

std::vector<std::string> names(const Database& database) {
  std::vector<std::string> result;
  for (const Unrendered& thing : unrendered(database)) result.push_back(thing.what);
  return result;
}

TEST(Unrendered, IsNothingWhereEverythingIsDrawn) {
  Database database;
  database.camera.emplace();
  database.lights.resize(1);
  for (int kind = 0; kind < kSolidKindCount; ++kind) {
    database.solids.push_back({.kind = static_cast<SolidKind>(kind)});
    database.objects.push_back(object(Object::Kind::solid, static_cast<std::uint32_t>(database.solids.size() - 1)));
  }
  database.blobs.resize(1);
  for (const Operation operation : {Operation::unite, Operation::merge, Operation::intersect, Operation::subtract}) {
    database.groups.push_back({.operation = operation, .children = {object(Object::Kind::blob, 0)}});
    database.objects.push_back(object(Object::Kind::group, static_cast<std::uint32_t>(database.groups.size() - 1)));
  }
  database.objects.back().clip = GroupId{0};
  EXPECT_THAT(names(database), ElementsAre());
}

TEST(Unrendered, TellsEachKindOnceWithItsFirstPlaceAndHowOften) {
  Database database;
  database.solids.resize(1);
  database.objects = {object(Object::Kind::solid, 0, 7), object(Object::Kind::solid, 0, 8),
                      object(Object::Kind::solid, 0, 9)};
  database.objects[0].no_image = database.objects[2].no_image = true;
  database.objects[1].double_illuminate = true;
  const std::vector<Unrendered> things = unrendered(database);
  ASSERT_EQ(things.size(), 2u);
  EXPECT_EQ(things[0].what, "`no_image`");
  EXPECT_EQ(things[0].origin, OriginId{7});
  EXPECT_EQ(things[0].count, 2u);
  EXPECT_EQ(things[1].what, "`double_illuminate`");
}

TEST(Unrendered, LooksIntoEachSharedGroupOnce) {
  Database database;
  database.solids.resize(1);
  Object hidden = object(Object::Kind::solid, 0, 5);
  hidden.no_image = true;
  database.groups = {{.children = {hidden}},
                     {.operation = Operation::subtract, .children = {hidden}}};
  database.objects = {object(Object::Kind::group, 0), object(Object::Kind::group, 0), object(Object::Kind::group, 1)};
  const std::vector<Unrendered> things = unrendered(database);
  ASSERT_EQ(things.size(), 1u);
  EXPECT_EQ(things[0].what, "`no_image`");
  EXPECT_EQ(things[0].count, 2u);
}

/// Everything that is on the list, once.
Database everything() {
  Database database;
  database.camera = Camera{.kind = CameraKind::fisheye, .blur = FocalBlur{}};
  Light light{.kind = LightKind::spotlight, .parallel = true, .fade_distance = 1, .fade_power = 1};
  light.area.emplace();
  light.projected_through = GroupId{0};
  database.lights = {light, {.kind = LightKind::cylinder}};
  database.camera->normal = NormalId{0};
  database.normals.resize(1);
  database.sky_sphere.emplace();
  database.fogs.resize(2);
  database.rainbows.resize(1);
  database.textures = {{.pigment = {{.transmit = 1}}, .normal = NormalId{0}, .finish = FinishId{0}},
                       {.pigment = {.pattern = PigmentId{0}}, .below = TextureId{0}},
                       {.pattern = TexturePatternId{0}}};
  database.finishes = {{.emission = {1, 0, 0},
                        .diffuse_back = 1,
                        .phong = 1,
                        .metallic = 1,
                        .reflection = {.maximum = {0, 1, 0}},
                        .irid = 1,
                        .crand = 1,
                        .phong_albedo = true}};
  database.pigments.resize(1);
  database.pigments[0].pattern.kind = PatternKind::image_map;
  database.pigments[0].map = PigmentMapId{0};
  database.pigment_maps = {{{0, {{1, 0, 0}}}, {1, {{0, 1, 0}}}}};
  database.texture_patterns.resize(1);
  database.texture_patterns[0].pattern.kind = PatternKind::slope;
  database.texture_patterns[0].map = TextureMapId{0};
  database.texture_maps = {{{0, TextureId{1}}}};
  database.solids.resize(1);
  database.objects.push_back(object(Object::Kind::solid, 0));
  database.groups = {{.is_light_group = true, .lights = {{}}}};
  database.objects.push_back(object(Object::Kind::group, 0));
  Object odd = object(Object::Kind::solid, 0);
  odd.no_image = odd.double_illuminate = true;
  odd.interior_texture = odd.texture = TextureId{0};
  database.objects.push_back(odd);
  for (std::uint32_t texture = 1; texture < 3; ++texture) {
    database.objects.push_back(object(Object::Kind::solid, 0));
    database.objects.back().texture = TextureId{texture};
  }
  return database;
}

TEST(Unrendered, NothingOfItIsThereAfterItWasLeftOut) {
  Database database = everything();
  EXPECT_EQ(names(database).size(), 27u);
  leave_out_unrendered(database);
  EXPECT_THAT(names(database), ElementsAre());
  EXPECT_EQ(database.textures[1].pigment.colour, (Colour{0.5, 0.5, 0})) << "the mean of what the pattern chooses from";
  EXPECT_EQ(database.textures[2].pigment.colour, (Colour{0.5, 0.5, 0})) << "the first of what the pattern chooses from";
}

TEST(Unrendered, OfLayersTheLowestAloneMustNotLetLightThrough) {
  Database database;
  database.textures = {{.pigment = {{1, 0, 0}}}, {.pigment = {{.transmit = 1}}}};
  database.default_texture = {.pigment = {{.filter = 1}}, .below = TextureId{0}};
  EXPECT_THAT(names(database), ElementsAre());
  database.default_texture.below = TextureId{1};
  EXPECT_THAT(names(database), ElementsAre("a transparent pigment"));
  leave_out_unrendered(database);
  EXPECT_THAT(names(database), ElementsAre());
  EXPECT_EQ(database.textures[1].pigment.colour.transmit, 0);
  EXPECT_EQ(database.default_texture.pigment.colour.filter, 1);
}

TEST(Unrendered, WhatAPatternChoosesIsLookedInto) {
  Database database;
  database.finishes = {{.irid = 1}};
  database.textures = {{.pigment = {{1, 0, 0}}}, {.pigment = {{.transmit = 1}}, .finish = FinishId{0}}};
  database.texture_patterns.resize(1);
  database.texture_patterns[0].pattern.kind = PatternKind::checker;
  database.texture_patterns[0].map = TextureMapId{0};
  database.texture_maps = {{{0, TextureId{0}}, {1, TextureId{1}}}};
  database.default_texture = {.pattern = TexturePatternId{0}};
  EXPECT_THAT(names(database), ElementsAre("a transparent pigment", "`irid`"));
}

TEST(Unrendered, APatternThatNeedsOnlyThePointIsDrawn) {
  Database database;
  database.pigments.resize(3);
  for (std::uint32_t i = 0; i < 3; ++i) {
    database.pigments[i].pattern.kind = i == 0 ? PatternKind::marble : PatternKind::checker;
    database.pigments[i].map = PigmentMapId{i};
  }
  database.pigment_maps = {{{0, {{1, 0, 0}}}, {1, {{0, 1, 0}}}},
                           {{0, {.pattern = PigmentId{0}}}, {1, {{0, 1, 0}}}},
                           {{0, {.pattern = PigmentId{1}}}, {1, {{.transmit = 0.5}}}}};
  const auto in_use = [&](std::uint32_t pigment) {
    database.default_texture = {.pigment = {.pattern = PigmentId{pigment}}};
    return names(database);
  };
  EXPECT_THAT(in_use(0), ElementsAre());
  EXPECT_THAT(in_use(1), ElementsAre());
  EXPECT_THAT(in_use(2), ElementsAre("a transparent pigment")) << "in a map of a map";
}

TEST(Unrendered, APlainPigmentMayHaveAPreviewColourToo) {
  Database database;
  database.pigments = {{.pattern = {}, .colour = {1, 0, 0}, .quick_colour = Colour{0, 1, 0}}};
  database.textures = {{.pigment = {.pattern = PigmentId{0}}}};
  database.solids.resize(1);
  database.objects = {object(Object::Kind::solid, 0)};
  database.objects[0].texture = TextureId{0};
  EXPECT_THAT(names(database), ElementsAre());
}

}  // namespace
}  // namespace isl::scene
