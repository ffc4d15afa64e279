// Surfaces that let light through, in whole pictures.
#include "tests/renderer/integrator/middle_pixel.h"

#include <cmath>
#include <numbers>

namespace isl::test {
namespace {

/// A parallel view along z through the origin, on a background.
std::string through(const std::string& what, const char* background = "<.8, .4, .2>", int level = 5) {
  return fmt::format(
             "global_settings {{ max_trace_level {} }} camera {{ location -5*z direction z right .001*x up .001*y }} "
             "background {{ rgb {} }} ",
             level, background) +
         what;
}

std::string clear_slab(const char* interior) {
  return fmt::format(
      "box {{ <-9, -9, 0>, <9, 9, 3> pigment {{ rgbt 1 }} finish {{ ambient 0 diffuse 0 }} interior {{ {} }} }} ",
      interior);
}

TEST(Transparency, mixes_with_what_is_behind_as_in_povray) {
  const auto sheet = [](const char* colour) {
    return fmt::format("plane {{ -z, 0 pigment {{ {} }} finish {{ ambient 1 diffuse 0 }} }} ", colour);
  };
  expect_middle(through(sheet("rgbft <.2, .4, .6, .5, .3>")), .36, .28, .24);
  expect_middle(through(sheet("rgbft <.2, .4, .6, .8, .4>")), .408, .208, .056);
}

TEST(Transparency, of_layers_is_that_of_all) {
  expect_middle(through("plane { -z, 0 texture { pigment { rgb <.9, .5, .1> } finish { ambient .5 diffuse 0 } } "
                        "texture { pigment { rgbft <.2, .4, .6, .5, .3> } finish { ambient 1 diffuse 0 } } } "),
                .22, .205, .15);
}

TEST(Transparency, ends_at_max_trace_level_and_adc_bailout) {
  std::string sheets;
  for (int i = 0; i < 3; ++i)
    sheets += fmt::format("plane {{ -z, {} pigment {{ rgbt <0, 0, 0, .1> }} finish {{ ambient 0 diffuse 0 }} }} ", -i);
  expect_middle(through(sheets, "1"), 0, 0, 0);
  expect_middle(
      "global_settings { adc_bailout .0005 } camera { location -5*z direction z right .001*x up .001*y } "
      "background { rgb 1 } " +
          sheets,
      .001, .001, .001);
  expect_middle(through(clear_slab("ior 1"), "1", 1), 0, 0, 0);
  // A way that does not bend does not count.
  expect_middle(through(clear_slab("ior 1"), "1", 2), 1, 1, 1);
  expect_middle(through(clear_slab("ior 1.5"), "1", 2), 0, 0, 0);
  expect_middle(through(clear_slab("ior 1.5"), "1", 3), 1, 1, 1);
}

TEST(Transparency, weighs_total_reflection_by_what_the_surface_lets_through) {
  // The camera is in the box. Both the reflecting face and the one behind it weigh 1/4, which adc_bailout ends or not.
  const auto within = [](const char* adc_bailout) {
    return fmt::format(
        "global_settings {{ adc_bailout {} }} {} {} box {{ <-50, -50, -60>, <50, 50, 0> pigment {{ rgbf .5 }} finish "
        "{{ ambient 0 diffuse 0 }} interior {{ ior 1.5 }} }} ",
        adc_bailout, kAt60, kBackground);
  };
  expect_middle(within(".05"), .2, .1, .05);
  expect_middle(within(".07"), 0, 0, 0);
}

TEST(Interior, fades_light_as_povrays) {
  const auto faded = [](const char* power) {
    return through(clear_slab(fmt::format("fade_distance 2 fade_color <.2, .4, .6> fade_power {}", power).c_str()),
                   "1");
  };
  expect_middle(faded("2"), .44616, .58462, .72308);
  expect_middle(faded("1001"), .30120, .40658, .54881);
  expect_middle(faded("0"), .6, .7, .8);
}

/// The direction in which a ray along z at x leaves the bodies, seen as a sky's colour.
void expect_exit(double x, const std::string& bodies, double to_x, double to_z) {
  const std::string scene =
      fmt::format(
          "global_settings {{ max_trace_level 20 }} camera {{ location <{}, 0, -5> direction z right .0001*x "
          "up .0001*y }} ",
          x) +
      "sky_sphere { pigment { function { .5 + .5*x } color_map { [0 rgb 0] [1 rgb 1] } } } "
      "#default { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } } " +
      bodies;
  const double expected = .5 + .5 * to_x;
  expect_middle(scene, expected, expected, expected, 1e-4);
  EXPECT_NEAR(to_x * to_x + to_z * to_z, 1, 1e-3);
}

TEST(Refraction, follows_snell_through_bodies_within_bodies) {
  constexpr double kPixel12 = 4 / 8.5, kPixel11 = 3 / 8.5;
  expect_exit(kPixel12, "sphere { 0, 1 interior { ior 1.5 } } ", -.3351, .9422);
  expect_exit(kPixel11, "sphere { 0, 1 interior { ior 1.5 } } sphere { 0, .7 interior { ior 1.33 } } ", -.1537, .9881);
  // A sphere of the same medium within another changes nothing.
  expect_exit(kPixel12, "sphere { 0, 1 interior { ior 1.5 } } sphere { 0, .7 interior { ior 1.5 } } ", -.3351, .9422);
}

TEST(Refraction, is_of_interiors_as_povrays) {
  // Two boxes, the second turned by 20 degrees, whose front lies within the first.
  const std::string boxes = "{ box { <-9, -9, 0>, <9, 9, 2> } box { <-9, -9, 1>, <9, 9, 9> rotate 20*y } ",
                    glass = "interior { ior 1.5 } } ";
  // Parts of a union that share an interior are entered and left in turns; those of a merged body are one.
  expect_exit(0, "union " + boxes + glass, -.39591, .91829);
  expect_exit(0, "merge " + boxes + glass, -.18852, .98207);
  // A part that has an interior of its own is a body of its own: its surface lets the ray in.
  expect_exit(0, "intersection { plane { -z, 0 " + glass + "plane { z, 2 rotate 30*y interior { ior 1.2 } } }", -.15095,
              .98854);
  expect_exit(0, "intersection { plane { -z, 0 } plane { z, 2 rotate 30*y } " + glass, -.3188, .94782);
}

TEST(Refraction, leaves_the_bodies_that_the_camera_stands_in) {
  const std::string tilted = "box { -9, <9, 9, 2> rotate 20*y interior { ior 1.2 } } ",
                    behind = "plane { z, 9 interior { ior 1.5 } } ", far = "sphere { <0, 90, 0>, 1 } ";
  expect_exit(0, tilted, -.07379, .99727);
  // In the order of the scene the plane was entered last: what is left before it bends nothing.
  expect_exit(0, tilted + behind, 0, 1);
  expect_exit(0, behind + tilted, .10778, .99417);
  // With three objects or more, what goes on without end was entered first.
  expect_exit(0, tilted + behind + far, .10778, .99417);
  // An object without an interior is a body as well, even if it is opaque.
  expect_exit(0, tilted + "sphere { 0, 50 pigment { rgb 1 } clipped_by { plane { z, 40 } } } ", 0, 1);
  // Boxes along an axis, here z, in the order of their middles.
  expect_exit(0, tilted + "box { <-30, -30, -60>, <30, 30, 9> interior { ior 1.5 } } sphere { -90*z, 1 } ", .10778,
              .99417);
}

TEST(Refraction, is_total_beyond_the_critical_angle) {
  // A prism of 45 degrees turns the ray along z to x.
  expect_exit(0, "intersection { box { -1, 1 } plane { <-1, 0, 1>, 0 } interior { ior 1.5 } } ", 1, 0);
}

TEST(Refraction, enters_a_single_face_whatever_way_its_corners_go) {
  for (const char* const corners : {"<-9, -9, -9>, <9, -9, 9>, <0, 9, 0>", "<9, -9, 9>, <-9, -9, -9>, <0, 9, 0>"})
    expect_exit(0, fmt::format("triangle {{ {} interior {{ ior 1.5 }} }} ", corners), -.2903, .9570);
}

TEST(Refraction, enters_what_is_open_where_it_is_met_first) {
  // The ray comes in through the hole and meets the far half of the sphere from within.
  const std::string ball = "sphere { 0, 1 ", far_half = ball + "clipped_by { plane { -z, 0 } } ",
                    near_half = ball + "clipped_by { plane { z, 0 } } ", glass = "interior { ior 1.5 } } ";
  expect_exit(.5, far_half + glass, .18273, .98316);
  expect_exit(.5, "cylinder { -y, y, 1 open " + glass, -.35931, .93322);
  // The halves of a union are one body.
  expect_exit(4 / 8.5, "union { " + near_half + "} " + far_half + "} " + glass, -.3351, .9422);
  expect_exit(4 / 8.5, "merge { " + near_half + "} " + far_half + "} " + glass, -.3351, .9422);
  expect_exit(4 / 8.5, "sphere { 0, 1 inverse " + glass, -.3351, .9422);
  // The camera is in the body.
  expect_exit(3.5, "sphere { 0, 7 clipped_by { plane { y, 3 } } " + glass, -.3188, .94782);
}

TEST(Refraction, films_colour_what_is_reflected_totally) {
  // The same prism: light comes and goes at 45 degrees to the film, whose thickness is 0.4.
  const auto film = [](double wavelength) {
    return 1 + .3 * std::cos(2 * std::numbers::pi * .4 * std::numbers::sqrt2 / wavelength);
  };
  expect_middle(
      "camera { location -5*z direction z right .001*x up .001*y } sky_sphere { pigment { rgb .5 } } "
      "intersection { box { -1, 1 } plane { <-1, 0, 1>, 0 } interior { ior 1.5 } pigment { rgbt 1 } "
      "finish { ambient 0 diffuse 0 irid { .3 thickness .4 } } } ",
      .5 * film(.70), .5 * film(.52), .5 * film(.48), 1e-6);
}

TEST(Shadows, of_what_lets_light_through_are_coloured_as_povrays) {
  const auto shadow = [](const char* what) {
    return fmt::format(
        "camera {{ location <0, 0, -1> direction z right .001*x up .001*y }} light_source {{ -100*z rgb 1 }} plane "
        "{{ -z, -1 pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 1 }} }} {} ",
        what);
  };
  expect_middle(shadow("disc { -5*z, z, 1 pigment { rgbft <.2, .4, .6, .5, .3> } }"), .4, .5, .6);
  expect_middle(shadow("sphere { -5*z, 1 pigment { rgbf <.2, .4, .6, .5> } }"), .01, .04, .09);
  expect_middle(shadow("sphere { -5*z, 1 pigment { rgbf <.2, .4, .6, .5> } interior { caustics 1 } }"), .04, .16, .36);
  expect_middle(shadow("disc { -5*z, z, 1 pigment { rgb 1 } }"), 0, 0, 0);
}

TEST(Shadows, of_what_is_open_fade_between_its_faces) {
  const std::string fading = "pigment { rgbt 1 } interior { fade_distance 1 fade_power 1001 fade_color 0 } } ",
                    disc = "disc { -5*z, z, 1 ";
  const auto lit = [](const std::string& what) {
    return "camera { location <0, 0, -1> direction z right .001*x up .001*y } light_source { -100*z rgb 1 } plane "
           "{ -z, -1 pigment { rgb 1 } finish { ambient 0 diffuse 1 } } " +
           what;
  };
  expect_middle(lit(disc + fading), 1, 1, 1);
  const double faded = std::exp(-2);
  expect_middle(lit("union { " + disc + "} " + disc + "translate -2*z } " + fading), faded, faded, faded);
  // The eye has gone in through the sheet before it, so light comes out of the body behind it.
  const double seen = std::exp(-1.5);
  expect_middle(lit("union { " + disc + "} disc { -.5*z, -z, 1 } " + fading), seen, seen, seen);
}

}  // namespace
}  // namespace isl::test
