// The plan holds the effects that a scene calls for and no others.
#include "renderer/effects/plan.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>

namespace isl::render::test {
namespace {

using testing::ElementsAre;

std::vector<std::string> names(const std::vector<PlannedEffect>& effects) {
  std::vector<std::string> result;
  for (const PlannedEffect& planned : effects) result.emplace_back(planned.effect->name);
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
  EXPECT_THAT(names(plan.called_for), ElementsAre("ambient", "lighting", "shadows"));
  EXPECT_FALSE(plan.has("highlights"));
  ASSERT_EQ(plan.called_for[2].requests.size(), 1u);
  EXPECT_EQ(plan.called_for[2].requests[0].origin, OriginId{7});
}

TEST(Plan, has_every_effect_in_one_list) {
  const Plan plan = plan_of(small_scene());
  EXPECT_EQ(plan.called_for.size() + plan.left_out.size() + plan.refused.size(), all_effects().size());
  for (const PlannedEffect& planned : plan.left_out) EXPECT_FALSE(planned.reason.empty()) << planned.effect->name;
}

TEST(Plan, without_light_has_ambient_light_only) {
  scene::Database database = small_scene();
  database.lights[0].colour = {};
  EXPECT_THAT(names(plan_of(database).called_for), ElementsAre("ambient"));
  database.settings.ambient_light = {};
  EXPECT_THAT(names(plan_of(database).called_for), ElementsAre());
}

TEST(Plan, with_shadowless_lights_only_has_neither_shadows_nor_highlights) {
  scene::Database database = small_scene();
  database.lights[0].shadowless = true;
  database.default_texture = isl::test::plain_texture(database, {}, {.phong = 1});
  const Plan plan = plan_of(database);
  EXPECT_TRUE(plan.has("lighting"));
  EXPECT_FALSE(plan.has("shadows") || plan.has("highlights"));
}

/// The small scene with a texture of this finish on its sphere.
scene::Database with_finish(const scene::Finish& finish) {
  scene::Database database = small_scene();
  database.textures.push_back(isl::test::plain_texture(database, {}, finish));
  database.objects[0].texture = scene::TextureId{0};
  return database;
}

TEST(Plan, follows_the_finishes_in_use) {
  EXPECT_TRUE(plan_of(with_finish({.specular = 0.1})).has("highlights"));
  EXPECT_FALSE(plan_of(with_finish({.specular = 0.1})).has("metallic"));
  EXPECT_TRUE(plan_of(with_finish({.specular = 0.1, .metallic = 1})).has("metallic"));
  EXPECT_FALSE(plan_of(with_finish({.metallic = 1})).has("metallic")) << "there is no highlight";
  EXPECT_TRUE(plan_of(with_finish({.reflection = {.maximum = {1, 0, 0}}})).has("reflection"));
  scene::Database unused = with_finish({.specular = 0.1});
  unused.objects[0].texture = scene::kNoTexture;
  EXPECT_FALSE(plan_of(unused).has("highlights"));
}

TEST(Plan, has_no_shadows_where_nothing_throws_one) {
  scene::Database database = small_scene();
  database.objects[0].no_shadow = true;
  EXPECT_FALSE(plan_of(database).has("shadows"));
}

TEST(Plan, looks_into_groups) {
  scene::Database database = small_scene();
  scene::Object hidden = database.objects[0];
  hidden.no_shadow = true;
  database.groups.push_back({.children = {hidden}});
  database.objects[0].kind = scene::Object::Kind::group;
  EXPECT_FALSE(plan_of(database).has("shadows")) << "the only child throws none";
  database.groups[0].children.push_back(scene::Object{.shape = 0});
  EXPECT_TRUE(plan_of(database).has("shadows"));
}

TEST(Plan, follows_the_quality) {
  const scene::Database database = small_scene();
  EXPECT_THAT(names(plan_of(database, {.quality = 0}).called_for), ElementsAre("plain_colours"));
  EXPECT_THAT(names(plan_of(database, {.quality = 1}).called_for), ElementsAre("plain_colours"));
  EXPECT_TRUE(plan_of(database, {.quality = 2}).has("lighting"));
  EXPECT_FALSE(plan_of(database, {.quality = 3}).has("shadows"));
  EXPECT_TRUE(plan_of(database, {.quality = 4}).has("shadows"));
}

TEST(Plan, leaves_out_what_it_is_told_to) {
  const Plan plan =
      plan_of(with_finish({.reflection = {.maximum = {1, 0, 0}}}), {.without = {"reflection", "shadows"}});
  EXPECT_THAT(names(plan.called_for), ElementsAre("ambient", "lighting"));
}

}  // namespace
}  // namespace isl::render::test
