// Lights and finishes in whole pictures.
#include "tests/renderer/integrator/middle_pixel.h"

#include <array>

namespace isl::test {
namespace {

using render::Rgb;

/// A grey value where a camera that looks along z sees z = 0 at x.
void expect_at(double x, const std::string& scene, double value) {
  expect_middle(fmt::format("camera {{ location <{}, 0, -5> direction z right .001*x up .001*y }} ", x) + scene, value,
                value, value, 1e-4);
}

/// The x of the pixels 8, 11 and 14 in a picture that is 17 pixels wide and shows x from -1 to 1.
constexpr std::array<double, 3> kPixels = {0, 3 / 8.5, 6 / 8.5};

void expect_across(const std::string& scene, const std::array<double, 3>& values) {
  for (std::size_t i = 0; i < kPixels.size(); ++i) expect_at(kPixels[i], scene, values[i]);
}

std::string white() { return plane("diffuse 1", "1"); }

TEST(Spotlight, is_povrays) {
  const auto light = [](int tightness) {
    return fmt::format("light_source {{ -z rgb 1 spotlight point_at 0 radius 20 falloff 40 tightness {} }} ",
                       tightness);
  };
  expect_across(light(0) + white(), {1, .94299, .16957});
  expect_across(light(10) + white(), {1, .52430, .02246});
}

TEST(Spotlight, with_a_radius_above_its_falloff_has_a_sharp_edge_at_its_radius) {
  // The pixels are at 0, 19.4 and 35.2 degrees from the axis.
  const auto light = [](int radius, int falloff) {
    return fmt::format("light_source {{ -z rgb 1 spotlight point_at 0 radius {} falloff {} }} ", radius, falloff);
  };
  for (const int falloff : {0, 10, 30}) {
    for (const double x : {kPixels[0], kPixels[1]}) expect_at(x, light(30, falloff) + white(), 1 / std::hypot(1, x));
    expect_at(kPixels[2], light(30, falloff) + white(), 0);
  }
}

TEST(CylinderLight, is_povrays) {
  expect_across("light_source { -z rgb 1 cylinder point_at 0 radius .4 falloff .8 tightness 2 } " + white(),
                {1, .31229, .00194});
}

TEST(FadingLight, is_povrays) {
  expect_at(8 / 8.5, "light_source { -z rgb 1 fade_distance 2 fade_power 2 } " + white(), .98978);
  // At fade_distance nothing is lost.
  expect_at(0, "light_source { -2*z rgb 1 fade_distance 2 fade_power 3 } " + white(), 1);
}

TEST(ParallelLight, is_povrays) {
  expect_across("light_source { <3, 0, -4> rgb 1 parallel point_at 0 fade_distance 2 fade_power 1 } " + white(),
                {.45715, .47140, .48658});
  // A wall before the plane through its location has it too, and nothing throws a shadow there.
  expect_at(0, "light_source { z rgb 1 parallel point_at 2*z } box { <-1, -1, -2>, <1, 1, -1.9> no_image } " + white(),
            1);
}

TEST(Lights, that_a_scene_can_do_without_are_plain_without_them) {
  const auto without = [](const char* effect, const std::string& scene) {
    render::RenderOptions options;
    options.without = {effect};
    return middle_of(rendered(std::string(kHead) + kStraight + scene, 17, options).image).x;
  };
  EXPECT_NEAR(without("spotlight", "light_source { -z rgb 1 spotlight point_at 3*x } " + white()), 1, 1e-9);
  EXPECT_NEAR(without("cylinder_light", "light_source { -z rgb 1 cylinder point_at 3*x + z } " + white()), 1, 1e-9);
  EXPECT_NEAR(without("fading_light", "light_source { -z rgb 1 fade_distance .1 fade_power 2 } " + white()), 1, 1e-9);
}

TEST(BackLight, is_povrays) {
  const auto disc = [](const char* finish, const char* more) {
    return fmt::format(
        "{} light_source {{ 1e6*<0, 0, 1> rgb 1 }} disc {{ 0, z, 1 pigment {{ rgb <.2, .4, .6> }} finish "
        "{{ ambient 0 diffuse {} }} {} }} ",
        kStraight, finish, more);
  };
  expect_middle(disc(".8", ""), 0, 0, 0);
  expect_middle(disc(".8, .3", ""), .06, .12, .18);
  expect_middle(disc(".8", "double_illuminate"), .16, .32, .48);
}

TEST(Albedo, is_povrays) {
  const std::string view = std::string(kStraight);
  expect_middle(view + light_at(60) + plane("diffuse albedo .8 brilliance 2"), .06, .12, .18);
  expect_middle(view + light_at(30) + plane("phong albedo .1 phong_size 10"), .13051, .13051, .13051);
  // The first block sets the peak to 0.8, and the brilliance of a later block does not change it.
  expect_middle(view + light_at(60) +
                    "#declare F = finish { ambient 0 diffuse albedo .8 } "
                    "plane { -z, 0 pigment { rgb <.2, .4, .6> } finish { F brilliance 2 } } ",
                .04, .08, .12);
}

TEST(Emission, shines_without_light_and_adds_to_it) {
  expect_middle(kStraight + plane("emission <.1, .2, .5>"), .02, .08, .3);
  expect_middle(kStraight + light_at(60) + plane("emission .5 diffuse .8"), .18, .36, .54);
}

TEST(Irid, is_povrays) {
  expect_middle(kStraight + light_at(30) + plane("diffuse .6 irid { .4 thickness .3 }", ".5"), .29175, .35193, .31200);
}

/// Expects red to be `brightest` − 0.2·0.2·u, with u evenly distributed from 0 to 1.
void expect_grain(const std::string& surface, double brightest) {
  const std::string scene = std::string(kHead) + kStraight + light_at(60) + surface;
  constexpr int kSize = 64;
  const render::RenderResult result = rendered(scene, kSize);
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < result.image.rgba.size(); i += 4) {
    sum += result.image.rgba[i];
    squares += result.image.rgba[i] * result.image.rgba[i];
  }
  constexpr double kCount = kSize * kSize;
  const double mean = sum / kCount, deviation = std::sqrt(squares / kCount - mean * mean);
  // The bounds are five standard errors.
  const double expected = .2 * .2 / std::sqrt(12.0);
  EXPECT_NEAR(mean, brightest - .2 * .2 / 2, 5 * expected / kSize);
  EXPECT_NEAR(deviation, expected, 5 * expected / kSize);
}

TEST(Crand, darkens_by_half_of_its_amount_in_the_mean) { expect_grain(plane("diffuse .8 crand .2"), .2 * .4); }

TEST(Crand, darkens_clear_surfaces_as_much_as_opaque_ones) {
  expect_grain("plane { z, 0 pigment { rgbt <.2, .4, .6, .5> } finish { ambient 0 diffuse .8 crand .2 } } ", .2 * .2);
}

}  // namespace
}  // namespace isl::test
