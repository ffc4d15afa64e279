// The plan holds what a scene calls for and nothing else.
#include "renderer/effects/plan.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>

namespace isl::render::test {
namespace {

using testing::ElementsAre;

std::vector<std::string> names(const std::vector<PlannedEffect>& effects) {
  std::vector<std::string> result;
  for (const PlannedEffect& effect : effects) result.push_back(effect.name);
  return result;
}

/// A sphere and a light.
scene::Database small_scene() {
  scene::Database database;
  database.solids.emplace_back();
  scene::Object sphere;
  sphere.shape = 0;
  database.objects.push_back(sphere);
  database.lights.emplace_back();
  database.lights[0].origin = OriginId{7};
  return database;
}

TEST(Plan, of_a_light_and_an_object_has_shadows) {
  const Plan plan = plan_of(small_scene());
  EXPECT_TRUE(plan.lighting && plan.shadows && !plan.highlights && !plan.plain_colours);
  EXPECT_THAT(names(plan.called_for), ElementsAre("lighting", "shadows"));
  EXPECT_THAT(names(plan.left_out), ElementsAre("highlights"));
  EXPECT_EQ(plan.called_for[1].origin, OriginId{7});
}

TEST(Plan, without_light_is_empty) {
  scene::Database database = small_scene();
  database.lights[0].colour = {};
  const Plan plan = plan_of(database);
  EXPECT_FALSE(plan.lighting || plan.shadows || plan.highlights);
  EXPECT_THAT(names(plan.left_out), ElementsAre("lighting", "shadows", "highlights"));
}

TEST(Plan, with_shadowless_lights_only_has_neither_shadows_nor_highlights) {
  scene::Database database = small_scene();
  database.lights[0].shadowless = true;
  database.default_texture = isl::test::plain_texture(database, {}, {.phong = 1});
  const Plan plan = plan_of(database);
  EXPECT_TRUE(plan.lighting);
  EXPECT_FALSE(plan.shadows || plan.highlights);
}

TEST(Plan, with_shiny_textures_has_highlights) {
  scene::Database database = small_scene();
  database.textures.push_back(isl::test::plain_texture(database, {}, {.specular = 0.1}));
  EXPECT_TRUE(plan_of(database).highlights);
}

TEST(Plan, has_no_shadows_where_nothing_throws_one) {
  scene::Database database = small_scene();
  database.objects[0].no_shadow = true;
  EXPECT_FALSE(plan_of(database).shadows);
}

TEST(Plan, looks_into_groups) {
  scene::Database database = small_scene();
  scene::Object hidden = database.objects[0];
  hidden.no_shadow = true;
  database.groups.push_back({.children = {hidden}});
  database.objects[0].kind = scene::Object::Kind::group;
  EXPECT_FALSE(plan_of(database).shadows) << "the only child throws none";
  database.groups[0].children.push_back(scene::Object{});
  EXPECT_TRUE(plan_of(database).shadows);
}

TEST(Plan, follows_the_quality) {
  const scene::Database database = small_scene();
  EXPECT_TRUE(plan_of(database, 0).plain_colours);
  EXPECT_TRUE(plan_of(database, 1).plain_colours);
  EXPECT_TRUE(plan_of(database, 2).lighting);
  EXPECT_FALSE(plan_of(database, 3).shadows);
  EXPECT_TRUE(plan_of(database, 4).shadows);
}

}  // namespace
}  // namespace isl::render::test
