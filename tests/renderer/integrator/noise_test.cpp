// The rule that stops samples by the noise of pixels.
#include "renderer/film/surface_aovs.h"
#include "tests/renderer/integrator/noise_scenes.h"
#include "tests/renderer/integrator/rendered_text.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace isl::test {
namespace {

TEST(MaxNoise, is_kept_and_not_undercut_by_far) {
  // noise_soak draws a hundred scenes; of these few, none may be an exception.
  int told = 0;
  for (std::uint32_t scene = 1; scene <= 6; ++scene) {
    const double ratio = noise_over_asked(noise_scene(scene), 0.02, 2048, 24);
    if (std::isnan(ratio)) continue;
    ++told;
    EXPECT_GE(ratio, 0.5) << scene;
    EXPECT_LE(ratio, 1) << scene;
  }
  EXPECT_GE(told, 4);
}

TEST(MaxNoise, is_kept_where_few_samples_are_often_alike_by_chance) {
  // A floor of tiles out of focus: four samples of a pixel are often of one colour.
  const std::string scene =
      "global_settings { assumed_gamma 1 } camera { location <0, 2.6, -6.5> look_at <0, .75, 0> angle 42 "
      "focal_point <-.8, .45, 0> aperture .6 blur_samples 16 } plane { y, 0 pigment { checker rgb <.8, .75, .65>, "
      "rgb <.25, .3, .4> scale .6 } finish { ambient 1 diffuse 0 } }";
  const double ratio = noise_over_asked(scene, 0.02, 2048, 48);
  EXPECT_GE(ratio, 0.5);
  EXPECT_LE(ratio, 1);
}

render::RenderResult drawn(const std::string& scene, double max_noise) {
  render::RenderOptions options;
  options.max_noise = max_noise;
  options.aovs = {&render::samples_aov(), &render::noise_aov()};
  return rendered(scene, 32, options);
}

TEST(MaxNoise, takes_the_first_samples_alone_where_nothing_differs) {
  const render::RenderResult flat = drawn("background { rgb .5 } camera { }", 0.01);
  for (const double count : flat.image.layers[0].values) ASSERT_EQ(count, 4);
  for (const double noise : flat.image.layers[1].values) ASSERT_EQ(noise, 0);
}

TEST(MaxNoise, sees_what_few_samples_miss) {
  // A hole of 2 % of the hemisphere above the floor: 8 directions often miss it, and such pixels would stay black.
  const std::string scene =
      "global_settings { assumed_gamma 1 sky_light { } } background { rgb 20 } camera { location <0, .5, 0> look_at 0 "
      "sky "
      "z right .01*x up .01*z } plane { y, 0 pigment { rgb 1 } finish { diffuse 1 } } difference { sphere { 0, 3 } "
      "sphere { 0, 2.9 } cylinder { 0, 4*y, .41 } pigment { rgb 0 } }";
  const render::RenderResult picture = drawn(scene, 0.05);
  const std::vector<double>& rgba = picture.image.rgba;
  double least = 1e9, most = 0;
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    least = std::min(least, rgba[i]);
    most = std::max(most, rgba[i]);
  }
  // The share is sin² of the hole's half angle, for all pixels almost the same. Five times the noise that is asked for,
  // by the slope of the display's curve at that brightness.
  const double expected = 20 * (.41 * .41) / (2.95 * 2.95);
  EXPECT_NEAR(least, expected, 0.25 * expected * 2);
  EXPECT_NEAR(most, expected, 0.25 * expected * 2);
}

TEST(MaxNoise, counts_the_pixels_that_have_all_samples_and_more_noise) {
  const render::RenderResult picture = drawn(noise_scene(1), 0.04);
  EXPECT_EQ(picture.statistics.noisy_pixels, 0);
  for (const double noise : picture.image.layers[1].values) EXPECT_LE(noise, 0.04);
}

}  // namespace
}  // namespace isl::test
