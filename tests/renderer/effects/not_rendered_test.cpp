// Effects that the renderer does not draw yet are found wherever a scene states them, and are gone when left out.
#include "renderer/effects/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isl::render::test {
namespace {

using namespace scene;  // NOLINT: the records that make up a scene
using testing::ElementsAre;

scene::Object object(Object::Kind kind, std::uint32_t shape, std::uint32_t origin = 0) {
  Object result;
  result.kind = kind;
  result.shape = shape;
  result.origin = {origin};
  return result;
}

std::vector<Request> refused(const Database& database) {
  std::vector<Request> requests;
  for (const PlannedEffect& planned : plan_of(database).refused)
    requests.insert(requests.end(), planned.requests.begin(), planned.requests.end());
  return requests;
}

std::vector<std::string> names(const Database& database) {
  std::vector<std::string> result;
  for (const Request& request : refused(database)) result.push_back(request.what);
  return result;
}

void leave_out(Database& database) { leave_out(plan_of(database), database); }

TEST(NotRendered, IsNothingWhereEverythingIsDrawn) {
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

/// The database with a pigment and bumps by a density, and the textures 0 and 1 that have them.
void add_densities(Database& database) {
  database.pigments.resize(1);
  database.pigments[0].pattern.kind = PatternKind::density_file;
  database.normals.resize(1);
  database.normals[0].pattern.kind = PatternKind::density_file;
  database.textures = {{.pigment = {.pattern = PigmentId{0}}}, {.normal = NormalId{0}}};
  database.solids.resize(1);
}

Object textured(std::uint32_t texture, std::uint32_t origin) {
  Object result = object(Object::Kind::solid, 0, origin);
  result.texture = TextureId{texture};
  return result;
}

TEST(NotRendered, TellsEachKindOnceWithItsFirstPlaceAndHowOften) {
  Database database;
  add_densities(database);
  database.textures.push_back({.normal = NormalId{0}});
  database.objects = {textured(1, 7), textured(0, 8), textured(2, 9)};
  const std::vector<Request> things = refused(database);
  ASSERT_EQ(things.size(), 2u);
  EXPECT_EQ(things[0].what, "a pigment that depends on a density file");
  EXPECT_EQ(things[0].origin, OriginId{8});
  EXPECT_EQ(things[1].what, "a `normal` that depends on a density file");
  EXPECT_EQ(things[1].origin, OriginId{7});
  EXPECT_EQ(things[1].count, 2u);
}

TEST(NotRendered, LooksIntoEachSharedGroupOnce) {
  Database database;
  add_densities(database);
  database.groups = {{.children = {textured(0, 5)}}, {.children = {textured(0, 6)}}};
  database.objects = {object(Object::Kind::group, 0), object(Object::Kind::group, 0), object(Object::Kind::group, 1)};
  const std::vector<Request> things = refused(database);
  ASSERT_EQ(things.size(), 1u);
  EXPECT_EQ(things[0].what, "a pigment that depends on a density file");
  EXPECT_EQ(things[0].origin, OriginId{5});
  EXPECT_EQ(things[0].count, 1u);
}

TEST(NotRendered, PointsAtTheWordWhereItsPlaceIsKnown) {
  Database database;
  database.pigments.resize(1);
  database.pigments[0].pattern.kind = PatternKind::density_file;
  database.pigments[0].pattern.said_at = OriginId{3};
  database.textures = {{.pigment = {.pattern = PigmentId{0}}, .named_at = OriginId{4}}};
  database.solids.resize(1);
  database.objects = {object(Object::Kind::solid, 0, 5)};
  database.objects[0].texture = TextureId{0};
  const std::vector<Request> things = refused(database);
  ASSERT_EQ(things.size(), 1u);
  EXPECT_EQ(things[0].origin, OriginId{3});
  EXPECT_EQ(things[0].used_by, OriginId{4});
}

/// A database that calls for every effect on the list.
Database everything() {
  Database database;
  database.normals.resize(1);
  database.normals[0].pattern.kind = PatternKind::density_file;
  database.textures = {{.pigment = {{.transmit = 1}}, .normal = NormalId{0}, .finish = FinishId{0}},
                       {.pigment = {.pattern = PigmentId{0}}, .below = TextureId{0}},
                       {.pattern = TexturePatternId{0}}};
  database.finishes.resize(1);
  database.pigments.resize(1);
  database.pigments[0].pattern.kind = PatternKind::density_file;
  database.pigments[0].map = PigmentMapId{0};
  database.pigment_maps = {{{0, {{1, 0, 0}}}, {1, {{0, 1, 0}}}}};
  database.texture_patterns.resize(1);
  database.texture_patterns[0].pattern.kind = PatternKind::density_file;
  database.texture_patterns[0].map = TextureMapId{0};
  database.texture_maps = {{{0, TextureId{1}}}};
  database.solids.resize(1);
  database.objects.push_back(object(Object::Kind::solid, 0));
  Object odd = object(Object::Kind::solid, 0);
  odd.texture = TextureId{0};
  database.objects.push_back(odd);
  for (std::uint32_t texture = 1; texture < 3; ++texture) {
    database.objects.push_back(object(Object::Kind::solid, 0));
    database.objects.back().texture = TextureId{texture};
  }
  return database;
}

TEST(NotRendered, NothingOfItIsThereAfterItWasLeftOut) {
  Database database = everything();
  EXPECT_EQ(names(database).size(), 3u);
  leave_out(database);
  EXPECT_THAT(names(database), ElementsAre());
  EXPECT_EQ(database.textures[1].pigment.colour, (Colour{0.5, 0.5, 0})) << "the mean of what the pattern chooses from";
  EXPECT_EQ(database.textures[2].pigment.colour, (Colour{0.5, 0.5, 0})) << "the first of what the pattern chooses from";
}

TEST(Transparency, IsCalledForByTheLowestLayerAlone) {
  Database database;
  database.textures = {{.pigment = {{1, 0, 0}}}, {.pigment = {{.transmit = 1}}}};
  database.default_texture = {.pigment = {{.filter = 1}}, .below = TextureId{0}};
  EXPECT_FALSE(plan_of(database).has("transparency"));
  database.default_texture.below = TextureId{1};
  EXPECT_TRUE(plan_of(database).has("transparency"));
}

TEST(NotRendered, WhatAPatternChoosesIsLookedInto) {
  Database database;
  database.pigments.resize(1);
  database.pigments[0].pattern.kind = PatternKind::density_file;
  database.textures = {{.pigment = {{1, 0, 0}}}, {.pigment = {.pattern = PigmentId{0}}}};
  database.texture_patterns.resize(1);
  database.texture_patterns[0].pattern.kind = PatternKind::checker;
  database.texture_patterns[0].map = TextureMapId{0};
  database.texture_maps = {{{0, TextureId{0}}, {1, TextureId{1}}}};
  database.default_texture = {.pattern = TexturePatternId{0}};
  EXPECT_THAT(names(database), ElementsAre("a pigment that depends on a density file"));
}

TEST(NotRendered, APatternThatNeedsOnlyThePointIsDrawn) {
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
  EXPECT_THAT(in_use(2), ElementsAre());
  EXPECT_TRUE(plan_of(database).has("transparency")) << "in a map of a map";
}

TEST(NotRendered, APlainPigmentMayHaveAPreviewColourToo) {
  Database database;
  database.pigments = {{.pattern = {}, .colour = {1, 0, 0}, .quick_colour = Colour{0, 1, 0}}};
  database.textures = {{.pigment = {.pattern = PigmentId{0}}}};
  database.solids.resize(1);
  database.objects = {object(Object::Kind::solid, 0)};
  database.objects[0].texture = TextureId{0};
  EXPECT_THAT(names(database), ElementsAre());
}

}  // namespace
}  // namespace isl::render::test
