// Effects in whole pictures.
#include "tests/renderer/integrator/middle_pixel.h"

#include <gmock/gmock.h>

#include <cmath>

namespace isl::test {
namespace {

using render::Rgb;

TEST(Metallic, highlights_are_povrays) {
  expect_middle(kStraight + light_at(30) + plane("phong .9 phong_size 10"), .21358, .21358, .21358);
  expect_middle(kStraight + light_at(30) + plane("phong .9 phong_size 10 metallic"), .04475, .08696, .12917);
  expect_middle(kStraight + light_at(30) + plane("specular .9 roughness .1"), .63633, .63633, .63633);
  expect_middle(kStraight + light_at(60) + plane("specular .9 roughness .1 metallic .5"), .13321, .15329, .17339);
}

TEST(Reflection, follows_the_angle_as_povrays_does) {
  const std::string view = std::string(kAt60) + kBackground;
  expect_middle(view + plane("reflection { .1, .9 }"), .4, .2, .1);
  expect_middle(view + plane("reflection { .1, .9 falloff 3 }"), .16, .08, .04);
  expect_middle(view + plane("reflection { .5 metallic }"), .09897, .08711, .06236);
  expect_middle(view + plane("reflection rgb <1, .5, 0>"), .8, .2, 0);
}

TEST(UserDefinedCamera, sees_what_a_perspective_one_with_the_same_rays_sees) {
  const auto scene = [](const char* camera) {
    return std::string("#version 3.8; global_settings { assumed_gamma 1 } camera { ") + camera +
           " } plane { -z, -2 pigment { gradient x color_map { [0 rgb 0] [1 rgb <1, .5, .2>] } scale 20 translate -8*x "
           "} "
           "finish { emission 1 } } ";
  };
  const render::Rgb flat = middle_of(rendered(scene("location <1, .5, -2> direction 2*z right x up y")).image);
  const render::Rgb by_functions =
      middle_of(rendered(scene("user_defined location { function { 1 } function { .5 } function { -2 } } "
                               "direction { function { x } function { y } function { 2 } }"))
                    .image);
  EXPECT_GT(flat.x, .1);
  EXPECT_NEAR(by_functions.x, flat.x, 1e-12);
  const render::Rgb moving = middle_of(
      rendered(scene("user_defined location { function { 1 + x } function { .5 } function { -2 } } direction z"))
          .image);
  EXPECT_NEAR(moving.x, flat.x, 1e-12);
  EXPECT_EQ(middle_of(rendered(scene("user_defined location <1, .5, -2> direction { function { 0 } function { 0 } "
                                     "function { 1/x } }"))
                          .image),
            Rgb(0));
}

TEST(Normal, a_default_hands_on_its_size) {
  const auto scene = [](const char* defaults, const char* size) {
    return std::string(kStraight) + light_at(60) + defaults +
           fmt::format(
               "plane {{ -z, 0 pigment {{ rgb 1 }} normal {{ gradient x {} }} finish {{ ambient 0 diffuse 1 }} "
               "translate .25*x }} ",
               size);
  };
  const auto red = [](const std::string& text) { return middle_of(rendered(kHead + text).image).x; };
  EXPECT_NEAR(red(scene("#default { normal { bump_size 1.5 } } ", "")), red(scene("", "1.5")), 1e-12);
  EXPECT_GT(std::abs(red(scene("", "1.5")) - red(scene("", ""))), .05);
}

TEST(Reflection, by_fresnel_is_povrays) {
  const auto mirror = [](const char* reflection) {
    return std::string(kAt60) + kBackground +
           fmt::format(
               "plane {{ -z, 0 pigment {{ rgb <.2, .4, .6> }} finish {{ ambient 0 diffuse 0 {} }} interior {{ ior "
               "1.5 }} }} ",
               reflection);
  };
  expect_middle(mirror("reflection { 1 fresnel }"), .07135, .03568, .01784);
  expect_middle(mirror("reflection { .1, .9 fresnel }"), .13709, .06854, .03427);
  expect_middle(mirror("reflection { 1 fresnel metallic }"), .01765, .01553, .01112);
}

/// A plane that is seen and lit aslant. What POV-Ray 3.8 shows in the middle of it is in the tests that follow.
std::string aslant(const char* pigment, const char* finish) {
  return fmt::format(
      "#version 3.8; camera {{ orthographic location -5*z direction z right 4*x up 4*y }} "
      "light_source {{ <60, 0, -100> rgb 1 parallel point_at 0 }} sky_sphere {{ pigment {{ rgb <.2, .3, .4> }} }} "
      "plane {{ <.5, 0, -1>, 0 pigment {{ rgb <1, .5, .25> {} }} finish {{ ambient 0 diffuse 0 {} }} "
      "interior {{ ior 1.5 }} }} ",
      pigment, finish);
}

TEST(FresnelFinish, is_povrays) {
  expect_middle(aslant("", "diffuse .5 fresnel"), .45902, .22951, .11475);
  expect_middle(aslant("", "ambient .3 fresnel"), .28774, .14386, .07193);
  expect_middle(aslant("", "emission .3 fresnel .5"), .29387, .14693, .07347);
  expect_middle(aslant("", "phong 1 phong_size 1 fresnel"), .03705, .03705, .03705);
  expect_middle(aslant("", "specular 1 roughness 1 fresnel"), .03934, .03934, .03934);
  expect_middle(aslant("", "diffuse .4 brilliance 2 fresnel 2"), .33591, .16796, .08399);
}

TEST(FresnelFinish, sets_that_of_the_reflection) {
  expect_middle(aslant("", "reflection .6 fresnel"), .00491, .00735, .00981);
  expect_middle(aslant("", "fresnel reflection .6"), .00491, .00735, .00981);
  expect_middle(aslant("", "fresnel reflection { .1, .6 }"), .02409, .03613, .04817);
  expect_middle(aslant("", "fresnel reflection { .6 fresnel off }"), .12, .18, .24);
}

TEST(UseAlpha, hides_the_surface_where_the_pigment_is_clear) {
  const char* const shiny = "diffuse .5 phong .3 phong_size 1 specular .2 use_alpha reflection .4";
  expect_middle(aslant("transmit .6", shiny), .51743, .49374, .51987);
  expect_middle(aslant("filter .3 transmit .2", shiny), .5968, .49717, .45985);
  expect_middle(aslant("transmit 1", shiny), .2, .3, .4);
  const char* const conserving = "diffuse .5 specular .5 reflection { .1, .4 } use_alpha conserve_energy";
  expect_middle(aslant("transmit .6", conserving), .46087, .42327, .43552);
  expect_middle(aslant("filter .3 transmit .2", conserving), .52741, .41402, .36297);
}

TEST(Reflection, takes_from_what_is_behind_only_if_energy_is_conserved) {
  const auto mirror = [](const char* more) {
    return std::string(kAt60) + kBackground +
           fmt::format(
               "plane {{ -z, 0 pigment {{ rgbt <.2, .4, .6, .5> }} finish {{ ambient 0 diffuse 0 reflection .4 {} "
               "}} }} ",
               more);
  };
  expect_middle(mirror("conserve_energy"), .56, .28, .14);
  expect_middle(mirror(""), .72, .36, .18);
}

TEST(Reflection, ends_at_max_trace_level) {
  const auto mirrors = [](int level) {
    return fmt::format(
        "global_settings {{ max_trace_level {} }} camera {{ location 0 direction z right x up y }} "
        "#default {{ pigment {{ rgb 1 }} finish {{ ambient .3 diffuse 0 reflection .5 }} }} plane {{ -z, -1 }} plane "
        "{{ z, -1 }} ",
        level);
  };
  expect_middle(mirrors(1), .3, .3, .3);
  expect_middle(mirrors(2), .45, .45, .45);
  expect_middle(mirrors(3), .525, .525, .525);
  expect_middle(mirrors(5), .58125, .58125, .58125);
}

TEST(Reflection, ends_below_adc_bailout) {
  const std::string mirrors =
      "camera { location 0 direction z right x up y } #default { pigment { rgb 1 } finish { ambient .3 diffuse 0 "
      "reflection .1 } } "
      "plane { -z, -1 } plane { z, -1 } ";
  expect_middle("global_settings { adc_bailout .05 max_trace_level 20 } " + mirrors, .33, .33, .33);
  expect_middle("global_settings { adc_bailout .005 max_trace_level 20 } " + mirrors, .333, .333, .333);
  // Fresnel's reflectivity counts as it is at this angle, 0.08919, and any other as at its greatest angle.
  const auto at_60 = [](const char* adc_bailout, const char* reflection) {
    return fmt::format("global_settings {{ adc_bailout {} }} {} {} {}", adc_bailout, kAt60, kBackground,
                       plane(fmt::format("reflection {{ {} }} }} interior {{ ior 1.5", reflection)));
  };
  expect_middle(at_60(".08", "0, 1 fresnel"), .07135, .03568, .01784);
  expect_middle(at_60(".1", "0, 1 fresnel"), 0, 0, 0);
  expect_middle(at_60(".1", "0, .1"), .04, .02, .01);
}

TEST(Reflection, is_counted) {
  const auto result = rendered(std::string(kHead) + kAt60 + kBackground + plane("reflection .5"), 4);
  EXPECT_THAT(result.statistics.paths.spawned, testing::ElementsAre(16u));
  render::RenderOptions without;
  without.without = {"reflection"};
  const auto left_out = rendered(std::string(kHead) + kAt60 + kBackground + plane("reflection .5"), 4, without);
  EXPECT_THAT(left_out.statistics.paths.spawned, testing::IsEmpty());
  EXPECT_EQ(middle_of(left_out.image), Rgb(0));
}

TEST(Fog, is_povrays) {
  const auto wall = [](const char* fogs) {
    return fmt::format(
        "camera {{ location -10*z direction z right x up y }} {} plane {{ -z, 0 pigment {{ rgb <.2, .4, .6> }} "
        "finish {{ ambient 1 diffuse 0 }} }} ",
        fogs);
  };
  expect_middle(wall("fog { distance 10 rgb <1, .8, .6> }"), .7057, .65284, .6);
  expect_middle(wall("fog { distance 10 rgbf <1, .8, .6, .5> }"), .7057, .63813, .55586);
  expect_middle(wall("fog { distance 10 rgbft <1, .8, .6, .5, .5> }"), .6, .58, .54);
  expect_middle(wall("fog { distance 10 rgb <1, .8, .6> } fog { distance 20 rgb <0, 1, 0> }"), .67675, .98842, .51315,
                2e-3);
}

TEST(Fog, hides_the_background_and_stays_out_of_solids) {
  const std::string fog = std::string(kStraight) + "background { rgb <0, 0, 1> } fog { distance 10 rgb <1, .5, 0> } ";
  expect_middle(fog, 1, .5, 0);
  expect_middle(fog + "sphere { -5*z, 1000 pigment { rgb .5 } finish { ambient 1 diffuse 0 } }", .5, .5, .5);
  expect_middle(fog + "sphere { -5*z, 1000 pigment { rgb .5 } finish { ambient 1 diffuse 0 } hollow }", 1, .5, 0, 1e-4);
  // A disc bounds a half-space in combinations of solids only, and an inverse ball nothing beyond its box.
  expect_middle(fog + "disc { 90*x, z, 1 } disc { 90*x, -z, 1 } union { disc { 90*x, z, 1 } disc { 90*x, -z, 1 } }", 1,
                .5, 0);
  expect_middle(fog + "sphere { 90*x, 1 inverse }", 1, .5, 0);
}

TEST(Fog, of_type_2_thins_out_above_its_offset) {
  const std::string floor =
      "camera { location 2*y direction -y right x up z } plane { y, 0 pigment { rgb <.2, .4, .6> } finish { ambient 1 "
      "diffuse 0 } } ";
  // The depth is 0.5 up to the offset, and 1.5 arctan 1 from there to the eye.
  const double share = std::exp(-(.5 + 1.5 * std::atan(1)) / 10);
  expect_middle(floor + "fog { fog_type 2 distance 10 rgb <1, .8, .6> fog_offset .5 fog_alt 1.5 }",
                .2 * share + 1 - share, .4 * share + .8 * (1 - share), .6);
  // Without an altitude, there is none above the offset.
  const double below = std::exp(-.5 / 10);
  expect_middle(floor + "fog { fog_type 2 distance 10 rgb <1, .8, .6> fog_offset .5 }", .2 * below + 1 - below,
                .4 * below + .8 * (1 - below), .6);
  // Transforms turn its height: here, the eye and the floor are at the same.
  const double level = std::exp(-2 / 10. / (1 + 1));
  expect_middle(floor + "fog { fog_type 2 distance 10 rgb <1, .8, .6> fog_offset -1 fog_alt 1 rotate 90*z }",
                .2 * level + 1 - level, .4 * level + .8 * (1 - level), .6);
}

TEST(Fog, is_turbulent_as_povrays) {
  // POV-Ray 3.7's pixel, which 16 bits give to 1e-5.
  expect_middle(
      "camera { location <.1, .2, .3> direction z right x up y angle 1 } plane { z, 2.3 hollow pigment { rgb 0 } "
      "finish "
      "{ ambient 0 diffuse 0 } } fog { distance 4 rgb 1 turbulence <3, 4, 5> turb_depth .4 octaves 2 }",
      .32294, .32294, .32294, 1e-4);
}

TEST(Rainbow, lies_around_its_direction) {
  const std::string wall =
      "camera { location -10*z direction z right x up y } plane { -z, 0 pigment { rgb <.2, .4, .6> } finish { ambient "
      "1 "
      "diffuse 0 } } ";
  // The direction is 20 degrees from the middle ray, which so meets the middle of the band.
  const std::string bow =
      "rainbow { direction <.34202014332566873, 0, .9396926207859084> angle 20 width 10 distance 10 color_map { "
      "[0 rgb x] [1 rgb z] } ";
  const double share = std::exp(-1);
  const double red = .2 * share + .5 * (1 - share), green = .4 * share, blue = .6 * share + .5 * (1 - share);
  expect_middle(wall + bow + "}", red, green, blue);
  expect_middle(wall + bow + "}" + bow + "}", red, green, blue);
  expect_middle(wall + bow + "angle 26 }", .2, .4, .6);
  expect_middle(wall + bow + "arc_angle 120 }", .2, .4, .6);
  // A declared arc may be made narrower.
  expect_middle("#declare Bow = " + bow + "arc_angle 300 } " + wall + "rainbow { Bow arc_angle 200 }", red, green,
                blue);
}

TEST(Rainbow, fades_out_to_its_arc_angle) {
  // The middle ray is 45 degrees from `up`, halfway between 30 and 60.
  expect_middle(
      "camera { location 0 direction z right x up y } background { rgb <0, 1, 0> } rainbow { direction "
      "<.34202014332566873, 0, .9396926207859084> up <-.9396926207859084, 1, .34202014332566873> angle 20 width 10 "
      "arc_angle 120 falloff_angle 60 color_map { [0 rgb x] [1 rgb z] } }",
      .25, .5, .25);
}

TEST(SkySphere, lays_its_pigments_over_the_background) {
  const std::string sky =
      "background { rgb <1, 0, 0> } sky_sphere { pigment { rgbt <0, 1, 0, .5> } pigment { rgbft <0, .4, 1, .25, .25> } "
      "} ";
  expect_middle(kStraight + sky, .125, .375, .5);
}

TEST(SkySphere, before_version_3_7_dims_layers_without_colouring_them) {
  const std::string view = std::string("#version 3.6; background { rgb <1, .5, .25> } ") + kStraight;
  constexpr double kByte = 1.0 / 255;  // POV-Ray's values have eight bits
  expect_middle(view + "sky_sphere { pigment { rgb <.2, .4, .6> } pigment { rgbf <.4, .6, .8, .5> } }", .302, .502,
                .702, kByte);
  expect_middle(view + "sky_sphere { pigment { rgbft <.4, .6, .8, .2, .1> } pigment { rgbft <.8, .6, .4, .3, .4> } }",
                .4941, .5059, .5255, kByte);
  expect_middle(view +
                    "sky_sphere { pigment { rgb <.2, .4, .6> } pigment { rgbft <0, 0, 0, .2, .1> } "
                    "pigment { rgbft <0, 0, 0, .3, .4> } }",
                .0196, .0392, .0588, kByte);
  expect_middle(view + "sky_sphere { pigment { rgbf <.4, .6, .8, .5> } }", .4, .451, .502, kByte);
}

TEST(SkySphere, is_looked_up_by_the_direction) {
  const std::string sky = "sky_sphere { pigment { gradient y color_map { [0 rgb 0] [1 rgb 1] } } } ";
  expect_middle("camera { location <7, 8, 9> look_at <7, 8.5, 9.866025403784> right x up y } " + sky, .5, .5, .5);
  // A mirror tilted by 15 degrees sends a ray along z up by 30.
  expect_middle(
      "camera { location 0 direction z right x up y } " + sky +
          "plane { <0, .25881904510252074, -.9659258262890683>, -2 finish { ambient 0 diffuse 0 reflection 1 } } ",
      .5, .5, .5);
}

TEST(HiddenObjects, are_seen_by_the_rays_that_they_are_not_hidden_from) {
  // A red ball in front of the mirror, and a green one behind the camera, which the mirror shows.
  const auto scene = [](const char* front, const char* back) {
    return fmt::format(
        "camera {{ location -5*z direction z right .01*x up .01*y }} #default {{ finish {{ ambient 1 diffuse 0 }} }} "
        "plane {{ -z, 0 pigment {{ rgb 0 }} finish {{ reflection 1 }} }} sphere {{ -2*z, .5 pigment {{ rgb x }} {} }} "
        "sphere {{ -9*z, .5 pigment {{ rgb y }} {} }} ",
        front, back);
  };
  expect_middle(scene("", ""), 1, 0, 0);
  expect_middle(scene("no_image", ""), 1, 0, 0);  // the mirror shows its back
  expect_middle(scene("no_image no_reflection", ""), 0, 1, 0);
  expect_middle(scene("no_image no_reflection", "no_image"), 0, 1, 0);
  expect_middle(scene("no_image no_reflection", "no_reflection"), 0, 0, 0);
}

}  // namespace
}  // namespace isl::test
