// One light on one point, compared with what POV-Ray 3.7 shows there: a plane z = 0 seen from <0, 0, −1>, pigment rgb
// <0.4, 0.6, 0.8>, light colour rgb <0.5, 0.7, 0.9>, ambient 0; assumed_gamma 1, File_Gamma=1.0, 16 bits, rounded to 5
// digits.
#include "renderer/shading/lighting.h"
#include "tests/renderer/shading/lit_point.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace isl::render::test {
namespace {

/// Half a unit of 16 bits, POV-Ray's single precision, and the rounding of the numbers below.
constexpr double kPovrayDigits = 2.5e-5;

class Plane {
 public:
  explicit Plane(const scene::Finish& finish) {
    database_.textures.push_back(isl::test::plain_texture(database_, {0.4, 0.6, 0.8}, finish));
    light_.colour = {0.5, 0.7, 0.9};
  }

  [[nodiscard]] Rgb lit_from(const Vec3& location) {
    light_.location = location;
    const MaterialTable materials(database_);
    const Vec3 view(0, 0, 1);
    const Material& material = materials[scene::TextureId(0)];
    const std::vector<LitTexture> textures = {{&material, material.pigment, material.pigment, 1}};
    const ShadingPoint point{{0, 0, 0}, turned_to_viewer(normal, view), view, textures};
    return lit_by(light_, point);
  }

  Vec3 normal{0, 0, -1};
  scene::Light light_;

 private:
  scene::Database database_;
};

void expect_colour(const Rgb& colour, double red, double green, double blue) {
  EXPECT_NEAR(colour.x, red, kPovrayDigits);
  EXPECT_NEAR(colour.y, green, kPovrayDigits);
  EXPECT_NEAR(colour.z, blue, kPovrayDigits);
}

const double kSqrt3 = std::sqrt(3.0);

TEST(Lighting, diffuse_follows_the_cosine) {
  expect_colour(Plane({.diffuse = 0.5}).lit_from({0, 0, -5}), 0.10001, 0.20999, 0.36001);
  expect_colour(Plane({.diffuse = 0.5}).lit_from({0, 5 * kSqrt3, -5}), 0.05, 0.105, 0.18);
}

TEST(Lighting, brilliance_is_the_exponent_of_the_cosine) {
  expect_colour(Plane({.diffuse = 0.5, .brilliance = 2}).lit_from({0, 5 * kSqrt3, -5}), 0.02499, 0.05251, 0.09);
  expect_colour(Plane({.diffuse = 0.5, .brilliance = 0.5}).lit_from({0, 5 * kSqrt3, -5}), 0.07071, 0.14849, 0.25455);
  expect_colour(Plane({.diffuse = 0.5, .brilliance = 0}).lit_from({0, 5 * kSqrt3, -5}), 0.10001, 0.20999, 0.36001);
}

TEST(Lighting, phong_takes_the_light_and_the_mirrored_view) {
  expect_colour(Plane({.diffuse = 0, .phong = 0.5, .phong_size = 10}).lit_from({0, 2, -5}), 0.11904, 0.16664, 0.21425);
  expect_colour(Plane({.diffuse = 0, .phong = 0.5, .phong_size = 1}).lit_from({0, 5 * kSqrt3, -5}), 0.125, 0.17501,
                0.22499);
  expect_colour(Plane({.diffuse = 0, .phong = 0.5, .phong_size = 0}).lit_from({0, 2, -5}), 0.25, 0.35, 0.45);
}

TEST(Lighting, specular_takes_the_half_angle) {
  expect_colour(Plane({.diffuse = 0, .specular = 0.5, .roughness = 0.1}).lit_from({0, 2, -5}), 0.20838, 0.29174,
                0.37508);
  expect_colour(Plane({.diffuse = 0, .specular = 0.5, .roughness = 1}).lit_from({0, 5 * kSqrt3, -5}), 0.21651, 0.30311,
                0.38972);
  expect_colour(Plane({.diffuse = 0, .specular = 0.5, .roughness = 1e-4}).lit_from({0, 0.02, -5}), 0.24504, 0.34307,
                0.44109);
}

TEST(Lighting, roughness_zero_is_a_highlight_everywhere) {
  expect_colour(Plane({.diffuse = 0.1, .specular = 1, .roughness = 0}).lit_from({0, 2, -5}), 0.51856, 0.73899, 0.96686);
}

TEST(Lighting, a_light_behind_the_surface_gives_nothing_not_even_highlights) {
  const scene::Finish shiny{.diffuse = 0.5, .phong = 1, .phong_size = 1, .specular = 1, .roughness = 1};
  for (const Vec3& location : {Vec3(0, 0, 5), Vec3(0, 5, 0.5), Vec3(0, 5, 0), Vec3(0, 5, 1e-9)}) {
    EXPECT_TRUE(Plane(shiny).lit_from(location) == Rgb(0)) << location;
  }
  expect_colour(Plane(shiny).lit_from({0, 5, -0.00001}), 0.35355, 0.49497, 0.63639);
}

TEST(Lighting, the_side_that_is_seen_is_the_side_that_is_lit) {
  Plane from_inside({.diffuse = 0.5});
  from_inside.normal = {0, 0, 1};
  EXPECT_EQ(from_inside.lit_from({0, 0, -5}), Plane({.diffuse = 0.5}).lit_from({0, 0, -5}));
}

TEST(Lighting, a_shadowless_light_gives_no_highlights) {
  Plane plane({.diffuse = 0.5, .phong = 1, .phong_size = 1, .specular = 1, .roughness = 1});
  plane.light_.shadowless = true;
  expect_colour(plane.lit_from({0, 2, -5}), 0.09285, 0.19498, 0.33425);
}

TEST(Lighting, a_negative_light_takes_away) {
  Plane plane({.diffuse = 0.5});
  plane.light_.colour = {-0.2, -0.2, -0.2};
  expect_colour(plane.lit_from({0, 2, -5}), 0.36286 - 0.4, 0.54429 - 0.6, 0.72572 - 0.8);
}

TEST(Lighting, a_light_at_the_point_itself_gives_nothing) {
  EXPECT_TRUE(Plane({.diffuse = 0.5}).lit_from({0, 0, 0}) == Rgb(0));
}

TEST(Lighting, ambient_is_the_finishs_times_the_scenes_times_the_pigment) {
  scene::Database database;
  database.settings.ambient_light = {0.5, 1, 2};
  database.default_texture = isl::test::plain_texture(database, {0.4, 0.6, 0.8}, {.ambient = {0.1, 0.2, 0.3}});
  const MaterialTable materials(database);
  const Material& material = materials[scene::kNoTexture];
  const std::vector<LitTexture> textures{{&material, material.pigment, material.pigment, 1}};
  const Rgb colour = ambient_colour({{}, {0, 0, -1}, {0, 0, 1}, textures});
  expect_colour(colour, 0.02, 0.12, 0.48);
}

}  // namespace
}  // namespace isl::render::test
