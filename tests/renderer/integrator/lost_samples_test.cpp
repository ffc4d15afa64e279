// Samples whose colour is no finite number are left out of the picture, and counted.
#include "tests/renderer/integrator/middle_pixel.h"

#include <algorithm>
#include <cmath>

namespace isl::test {
namespace {

/// A ball before a plain background. Its light overflows: 1e200 × 1e200.
constexpr const char* kBlindingBall =
    "camera { location -5*z direction z right x up y } background { rgb <.8, .4, .2> } "
    "light_source { -9*z rgb 1e200 } sphere { 0, 1 pigment { rgb 1e200 } } ";
/// A light of +∞ and one of −∞, whose sum is no number.
constexpr const char* kDarkLight = "light_source { -9*z rgb -1e200 } ";

bool is_finite(const render::Image& image) {
  return std::ranges::all_of(image.rgba, [](double value) { return std::isfinite(value); });
}

TEST(LostSamples, leave_a_pixel_to_the_others) {
  for (const std::string& scene : {std::string(kBlindingBall), kBlindingBall + std::string(kDarkLight)}) {
    render::RenderOptions options;
    options.samples = 16;
    const render::RenderResult result = rendered(kHead + scene, 31, options);
    ASSERT_TRUE(is_finite(result.image));
    EXPECT_GT(result.statistics.lost.samples, result.statistics.lost.pixels);
    // A pixel is black if all of it is lost, or has the colour of its other samples.
    int black = 0;
    for (std::size_t pixel = 0; pixel < result.image.rgba.size(); pixel += 4) {
      const double* const rgba = &result.image.rgba[pixel];
      EXPECT_EQ(rgba[3], 1);
      if (rgba[0] == 0) {
        ++black;
      } else {
        EXPECT_NEAR(rgba[0], .8, 1e-12);
        EXPECT_NEAR(rgba[1], .4, 1e-12);
      }
    }
    EXPECT_GT(black, 0);
    EXPECT_LT(static_cast<std::uint64_t>(black), result.statistics.lost.pixels);
  }
}

TEST(LostSamples, are_told_with_their_first_pixel_and_what_it_shows) {
  const render::RenderResult result = rendered(std::string(kHead) + kBlindingBall, 31);
  const render::LostSamples& lost = result.statistics.lost;
  EXPECT_EQ(lost.samples, lost.pixels);
  EXPECT_NE(lost.origin, OriginId{});
  std::size_t black = 0;
  while (result.image.rgba[4 * black] != 0) ++black;
  EXPECT_EQ(lost.first.x + 31 * lost.first.y, static_cast<int>(black));
  EXPECT_EQ(rendered(std::string(kHead) + kBackground, 31).statistics.lost.samples, 0U);
}

TEST(LostSamples, do_not_keep_a_picture_from_its_end_that_stops_by_its_noise) {
  render::RenderOptions options;
  options.max_noise = .02;
  options.samples = std::nullopt;
  const render::RenderResult result = rendered(kHead + std::string(kBlindingBall) + kDarkLight, 31, options);
  EXPECT_TRUE(is_finite(result.image));
  EXPECT_GT(result.statistics.lost.samples, 0U);
  EXPECT_NEAR(result.image.rgba[0], .8, 1e-12);
}

TEST(LostSamples, of_layers_are_as_misses) {
  render::RenderOptions options;
  for (const render::SurfaceAov& row : render::surface_aovs()) options.aovs.push_back(&row.aov);
  const render::RenderResult result =
      rendered(std::string(kHead) +
                   "camera { location -5*z direction z right x up y } plane { -z, 0 pigment { function "
                   "{ sqrt(x) } colour_map { [0 rgb 1] [1 rgb 2] } } } ",
               31, options);
  EXPECT_TRUE(is_finite(result.image));
  for (const render::Layer& layer : result.image.layers)
    EXPECT_TRUE(std::ranges::all_of(layer.values, [](double value) { return std::isfinite(value); }))
        << layer.aov->name;
}

}  // namespace
}  // namespace isl::test
