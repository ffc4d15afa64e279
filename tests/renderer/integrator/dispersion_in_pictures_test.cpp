// Light that refraction parts into colours, in whole pictures.
#include "renderer/shading/spectrum.h"
#include "tests/renderer/integrator/middle_pixel.h"

#include <cmath>

namespace isl::test {
namespace {

using render::Rgb;

TEST(Spectrum, adds_up_to_white) {
  EXPECT_EQ(render::light_up_to(0), Rgb(0));
  EXPECT_EQ(render::light_up_to(1), Rgb(1));
  Rgb before(0);
  for (int i = 1; i <= 100; ++i) {
    const Rgb light = render::light_up_to(i / 100.0);
    for (int channel = 0; channel < 3; ++channel) EXPECT_GE(light[channel], before[channel]) << i;
    before = light;
  }
}

TEST(Spectrum, has_povrays_tints_of_seven_colours) {
  constexpr double kTints[7][3] = {{.0365, 0, .2047}, {.003, 0, .3665},  {0, .1095, .327}, {.0098, .3612, .098},
                                   {.2708, .3787, 0}, {.4167, .1506, 0}, {.257, 0, 0}};
  for (int i = 0; i < 7; ++i) {
    const Rgb tint = render::light_up_to((i + 1) / 7.0) - render::light_up_to(i / 7.0);
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(tint[channel], kTints[i][channel], .03) << i;
  }
}

TEST(Spectrum, bends_violet_more_than_red) {
  EXPECT_EQ(render::Wave().bend(), 0);
  EXPECT_TRUE(render::Wave().is_white());
  for (const double place : {0.0, .1, .5, .9, 1.0}) {
    EXPECT_FALSE(render::Wave(place).is_white());
    EXPECT_NEAR(render::Wave(place).bend(), .5 - place, 1e-4);
  }
}

/// Glass behind a face at 45 degrees, and a white wall in it from `edge` on.
std::string glass(const std::string& interior, double edge) {
  return fmt::format(
      "camera {{ orthographic location -50*z direction z right .001*x up .001*y }} "
      "plane {{ <-1, 0, -1>, 0 pigment {{ rgbt 1 }} finish {{ ambient 0 diffuse 0 }} interior {{ {} }} }} "
      "polygon {{ 5, <{}, -99>, <300, -99>, <300, 99>, <{}, 99>, <{}, -99> translate 100*z pigment {{ rgb 1 }} finish "
      "{{ "
      "ambient 1 diffuse 0 }} }} ",
      interior, edge, edge, edge);
}

/// Where the light that comes in at x = 0 is at z = 100, by Snell's law.
double place_at(double ior) {
  const double inside = std::asin(std::sqrt(.5) / ior);
  return 100 * std::tan(std::acos(-1.0) / 4 - inside);
}

TEST(Dispersion, bends_each_colour_by_its_index) {
  // Of seven colours the index of number i is 1.5 · 1.2^(1/2 - (i + 1/2)/7).
  for (int i = 0; i < 7; ++i) {
    const double place = place_at(1.5 * std::pow(1.2, .5 - (i + .5) / 7));
    // Violet is bent most, so the wall that begins at a place has the colours on its violet side.
    const Rgb without = render::light_up_to(i / 7.0), with = render::light_up_to((i + 1) / 7.0);
    expect_middle(glass("ior 1.5 dispersion 1.2", place + .01), without.x, without.y, without.z, 1e-4);
    expect_middle(glass("ior 1.5 dispersion 1.2", place - .01), with.x, with.y, with.z, 1e-4);
  }
}

TEST(Dispersion, needs_two_colours_and_an_index_that_differs) {
  const double place = place_at(1.5);
  expect_middle(glass("ior 1.5", place - .01), 1, 1, 1);
  expect_middle(glass("ior 1.5", place + .01), 0, 0, 0);
  const auto rays = [&](const char* interior) {
    return rendered(kHead + glass(interior, 5), 1).statistics.paths.spawned.at(0);
  };
  EXPECT_EQ(rays("ior 1.5 dispersion 1"), 1u);
  EXPECT_EQ(rays("ior 1.5 dispersion 1.1"), 7u);
  EXPECT_EQ(rays("ior 1.5 dispersion 1.1 dispersion_samples 20"), 20u);
}

TEST(Dispersion, parts_light_once_and_puts_it_together_behind_a_slab) {
  const std::string slab =
      "camera { location <-20, 0, -50> look_at 0 right .001*x up .001*y } background { rgb <.8, .4, .2> } "
      "global_settings { max_trace_level 10 } box { <-90, -90, 0>, <90, 90, 3> pigment { rgbt 1 } finish { ambient 0 "
      "diffuse 0 } interior { ior 1.5 dispersion 1.3 } } box { <-90, -90, 5>, <90, 90, 8> pigment { rgbt 1 } finish { "
      "ambient 0 diffuse 0 } interior { ior 1.3 dispersion 1.1 } } ";
  expect_middle(slab, .8, .4, .2);
  EXPECT_EQ(rendered(kHead + slab, 1).statistics.paths.spawned.at(0), 4 * 7u);
}

TEST(Dispersion, goes_through_bodies_in_bodies) {
  std::string balls =
      "camera { location <.3, .2, -9> look_at 0 right 2*x up 2*y } background { rgb <.8, .4, .2> } "
      "global_settings { max_trace_level 30 adc_bailout 0 } ";
  for (int i = 1; i <= 6; ++i)
    balls += fmt::format(
        "sphere {{ 0, {} pigment {{ rgbt 1 }} finish {{ ambient 0 diffuse 0 }} interior {{ ior {} "
        "dispersion 1.1 }} }} ",
        i * .3, 1 + .1 * i);
  expect_middle(balls, .8, .4, .2);
}

}  // namespace
}  // namespace isl::test
