// Patterns that depend on the surface, textures of its inside, mirrors with an exponent, and bumps of the camera, in
// whole pictures.
#include "tests/renderer/integrator/middle_pixel.h"

#include <cmath>
#include <numbers>

namespace isl::test {
namespace {

/// A parallel view along z through (x, y).
std::string at(double x, double y, const std::string& scene) {
  return fmt::format("camera {{ orthographic location <{}, {}, -5> direction z right .001*x up .001*y }} ", x, y) +
         scene;
}

void expect_grey(double x, double y, const std::string& scene, double value, double tolerance = 1e-4) {
  expect_middle(at(x, y, scene), value, value, value, tolerance);
}

double share_of(double cosine) { return std::asin(cosine) / std::numbers::pi + .5; }

// ---- slope and aoi --------------------------------------------------------------------------------------------------

const std::string kGlow = "finish { ambient 1 diffuse 0 } ";

std::string ball(const std::string& pattern, const std::string& more = "") {
  return "sphere { 0, 1 pigment { " + pattern + " color_map { [0 rgb 0] [1 rgb 1] } } " + kGlow + more + " } ";
}

TEST(Slope, is_the_angle_of_the_normal_in_the_world) {
  const double y = .47;
  expect_grey(0, y, ball("slope y"), share_of(y));
  expect_grey(.3, -y, ball("slope y"), share_of(-y));
  expect_grey(0, y, ball("slope y", "rotate 90*z"), share_of(y));
  expect_grey(0, y, "union { " + ball("slope y rotate 90*z") + " rotate 40*z } ", share_of(y));
  expect_grey(.4, .3, ball("slope <3, 4, 0>"), share_of(.6 * .4 + .8 * .3));
}

TEST(Slope, is_that_of_the_side_that_is_seen) {
  expect_grey(0, .4, ball("slope y", "clipped_by { plane { -z, 0 } }"), share_of(-.4));
}

TEST(Slope, has_a_range_and_an_altitude_as_povray) {
  expect_grey(0, .47, ball("slope { y, .4, .9 }"), (share_of(.47) - .4) / .5);
  expect_grey(0, .47, ball("slope { y altitude y }"), (share_of(.47) + .47) / 2);
  // The longer vector weighs more, and the altitude is that in the space of the pattern.
  expect_grey(-.3, .47, ball("slope { 3*y altitude x, -1, 1 }"), .75 * share_of(.47) + .25 * .35);
  expect_grey(0, .47, ball("slope { y altitude y, -1, 1 } scale 2"), (share_of(.47) + (.235 + 1) / 2) / 2);
}

TEST(Slope, may_be_towards_a_point_of_the_world) {
  const scene::Vec3 normal(.2, .3, -std::sqrt(1 - .13)), way = scene::Vec3(0, 4, 0) - normal;
  expect_grey(.2, .3, ball("slope { point_at 4*y }"), share_of(normal.dot(way) / way.length()));
  expect_grey(.2, .3, ball("slope { point_at 4*y } translate x"), share_of(normal.dot(way) / way.length()));
}

TEST(Slope, chooses_textures_and_follows_the_bumps_of_its_layer) {
  expect_grey(0, .47,
              "sphere { 0, 1 texture { slope y texture_map { [0 pigment { rgb 0 } " + kGlow +
                  "] [1 pigment { rgb 1 } " + kGlow + "] } } } ",
              share_of(.47));
  // POV-Ray 3.7's value.
  expect_grey(0, 3 / 8.5, ball("slope y", "normal { gradient y .8 }"), .58192, 5e-5);
}

TEST(Aoi, grows_from_a_half_at_the_rim_to_one_in_the_middle) {
  for (const char* more : {"", "inverse", "clipped_by { plane { -z, 0 } }", "rotate 30*x"}) {
    expect_grey(0, 0, ball("aoi", more), 1);
    expect_grey(.3, .4, ball("aoi", more), share_of(std::sqrt(.75)));
  }
  expect_grey(0, .995, ball("aoi"), share_of(std::sqrt(1 - .995 * .995)), 2e-3);
}

TEST(Aoi, is_nothing_where_there_is_no_surface) {
  expect_middle(at(0, 0, "sky_sphere { pigment { aoi color_map { [0 rgb <.2, .4, .6>] [1 rgb 1] } } } "), .2, .4, .6);
}

TEST(Aoi, filters_shadows_by_their_own_angle) {
  // The sheet lets light through that falls in steeply: 45 degrees to the normal give 3/4.
  const std::string sheet =
      "polygon { 5, <-9, -9>, <9, -9>, <9, 9>, <-9, 9>, <-9, -9> translate -z no_image pigment { aoi color_map { [.5 "
      "rgbt 0] "
      "[1 rgbt <0, 0, 0, 1>] } } } ";
  expect_grey(0, 0, "light_source { 1e6*<1, 0, -1> rgb 1 } " + sheet + plane("diffuse 1", "1"), std::sqrt(.5) / 2,
              1e-3);
}

// ---- interior_texture -----------------------------------------------------------------------------------------------

const std::string kTextures =
    "#declare W = texture { pigment { rgb 1 } finish { ambient 1 diffuse 0 } } "
    "#declare R = texture { pigment { rgb x } finish { ambient 1 diffuse 0 } } "
    "#declare B = texture { pigment { rgb z } finish { ambient 1 diffuse 0 } } "
    "#declare Tube = cylinder { -y, y, .5 open } #declare Cut = plane { -z, 0 } ";

void expect_textures(double x, const std::string& scene, double red, double green, double blue) {
  expect_middle(at(x, 0, kTextures + scene), red, green, blue);
}

TEST(InteriorTexture, is_seen_from_inside) {
  expect_textures(0, "object { Tube texture { W } interior_texture { R } } ", 1, 1, 1);
  expect_textures(0, "object { Tube texture { W } interior_texture { R } clipped_by { Cut } } ", 1, 0, 0);
  expect_textures(0, "sphere { 0, 1 texture { W } interior_texture { R } inverse } ", 1, 0, 0);
  expect_textures(0, "disc { 0, z, 1 texture { W } interior_texture { R } } ", 1, 0, 0);
  expect_textures(0, "disc { 0, -z, 1 texture { W } interior_texture { R } } ", 1, 1, 1);
}

TEST(InteriorTexture, is_handed_down_by_groups_as_the_texture_is) {
  const std::string half = "object { Tube clipped_by { Cut } ", far = "box { 9, 10 texture { W } } ";
  expect_textures(0, "union { " + half + "} " + far + "texture { W } interior_texture { B } } ", 0, 0, 1);
  expect_textures(0, "union { " + half + "texture { W } } " + far + "texture { W } interior_texture { B } } ", 0, 0, 1);
  expect_textures(
      0,
      "union { " + half + "texture { W } interior_texture { R } } " + far + "texture { W } interior_texture { B } } ",
      1, 0, 0);
  expect_textures(0, "merge { " + half + "} " + far + "texture { W } interior_texture { B } } ", 0, 0, 1);
}

TEST(InteriorTexture, is_not_that_of_the_surface_of_a_cut) {
  expect_textures(0,
                  "difference { box { -1, 1 texture { R } interior_texture { R } } sphere { -z, .5 texture { W } "
                  "interior_texture { B } } } ",
                  1, 1, 1);
}

TEST(InteriorTexture, of_a_blob_holds_for_all_its_components) {
  const std::string halves = "blob { threshold .5 sphere { 0, 2, 1 texture { W } } sphere { 0, 2, 1 } texture { W } ";
  expect_textures(0, halves + "interior_texture { R } } ", 1, 1, 1);
  expect_textures(0, halves + "interior_texture { R } inverse } ", 1, 0, 0);
}

TEST(InteriorTexture, lies_in_the_space_of_the_object_that_has_it) {
  const std::string stripes =
      "interior_texture { pigment { gradient x color_map { [.5 rgb x] [.5 rgb z] } } " + kGlow + "} ";
  // Before the translation the middle of the tube is at x = 0.
  expect_textures(.25, "object { Tube texture { W } " + stripes + "clipped_by { Cut } translate 0 } ", 1, 0, 0);
  expect_textures(.75, "object { Tube texture { W } " + stripes + "clipped_by { Cut } translate .5*x } ", 1, 0, 0);
  expect_textures(.75,
                  "union { object { Tube texture { W } clipped_by { Cut } translate x/4 } sphere { 9, 1 } texture { "
                  "W } " +
                      stripes + "translate x/4 } ",
                  0, 0, 1);
}

// ---- Mirrors --------------------------------------------------------------------------------------------------------

TEST(ReflectionExponent, is_povrays) {
  expect_middle(std::string(kAt60) + kBackground + plane("reflection { .5 exponent 2 }"), .44721, .31623, .22361);
  expect_middle(std::string(kAt60) + kBackground + plane("reflection .5 reflection_exponent 2"), .44721, .31623,
                .22361);
}

TEST(ReflectionExponent, holds_for_each_mirror_of_a_row) {
  // Each of two mirrors that face each other doubles the exponent and halves what it mirrors.
  const std::string other = "plane { z, -20 pigment { rgb 0 } finish { ambient <.4, .3, .2> diffuse 0 } } ";
  const auto twice = [&](double colour) { return .5 * std::sqrt(.5 * std::sqrt(colour)); };
  const std::string mirrors =
      "box { <-99, -99, 0>, <99, 99, 1> pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { .5 exponent 2 } } "
      "} "
      "box { <-99, 9, -99>, <99, 10, 99> pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { .5 exponent 2 } } "
      "} ";
  const std::string view = "camera { location <0, 5, -5> look_at <0, 8, 0> right .001*x up .001*y } ";
  expect_middle(view + "background { rgb <.8, .4, .2> } " + mirrors, twice(.8), twice(.4), twice(.2));
}

TEST(ReflectionExponent, bends_each_layer_by_its_own) {
  const std::string layers =
      "plane { -z, 0 texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { .5 exponent 2 } } } "
      "texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection .25 } } } ";
  expect_middle(std::string(kAt60) + kBackground + layers, .5 * std::sqrt(.8) + .25 * .8, .5 * std::sqrt(.4) + .25 * .4,
                .5 * std::sqrt(.2) + .25 * .2);
}

// ---- The camera's normal --------------------------------------------------------------------------------------------

/// Red is x/20 + 1/2 of the point of z = 0 that pixel (x, y) of 17 x 17 sees.
double seen(const std::string& camera, int x, int y) {
  const std::string wall =
      "plane { -z, 0 pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } scale 20 translate -10*x } " + kGlow + "} ";
  const render::Image image = rendered(kHead + ("camera { " + camera + " } ") + wall).image;
  return image.rgba[4 * image.window.index(x, y)];
}

TEST(CameraNormal, is_povrays) {
  const std::string straight = "location -5*z direction z right 2*x up 2*y ";
  EXPECT_NEAR(seen(straight + "normal { gradient x 1 }", 8, 8), .64518, 5e-5);
  EXPECT_NEAR(seen(straight + "normal { gradient x 1 }", 11, 6), .55203, 5e-5);
  EXPECT_NEAR(seen(straight + "normal { bumps 1 scale .2 }", 11, 6), .52749, 5e-5);
  EXPECT_NEAR(seen("location -5*z direction 3*z right 2*x up 2*y normal { gradient x 1 }", 11, 6), .49575, 5e-5);
  EXPECT_NEAR(
      seen("orthographic location -5*z direction z right 2*x up 2*y normal { gradient x 3 sine_wave rotate 30*z }", 11,
           6),
      .46386, 5e-5);
  EXPECT_NEAR(seen(straight + "angle 40 normal { ripples 2 scale .2 } rotate 20*y", 11, 6), .32599, 5e-5);
  EXPECT_NEAR(
      seen("fisheye location -5*z direction z right 2*x up 2*y angle 120 normal { wrinkles 1 scale .3 }", 11, 6),
      .74099, 5e-5);
}

}  // namespace
}  // namespace isl::test
