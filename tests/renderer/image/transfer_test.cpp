// The conversion of working space to light to code values, compared with POV-Ray 3.7: the values of a 16-bit PNG of
// background { rgb <0.5, 0.2, 0.01> }.
#include "renderer/image/transfer.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace isl::render::test {
namespace {

scene::Settings settings(double version, std::optional<double> gamma, bool srgb = false) {
  scene::Settings result;
  result.language_version = version;
  result.assumed_gamma = gamma;
  result.assumed_gamma_srgb = srgb;
  return result;
}

void expect_codes(const scene::Settings& scene_settings, int red, int green, int blue) {
  const Rgb linear = WorkingSpace(scene_settings).to_linear({0.5, 0.2, 0.01});
  EXPECT_NEAR(display_from_linear(linear.x) * 65535, red, 1);
  EXPECT_NEAR(display_from_linear(linear.y) * 65535, green, 1);
  EXPECT_NEAR(display_from_linear(linear.z) * 65535, blue, 1);
}

TEST(Transfer, gives_povrays_codes) {
  expect_codes(settings(3.7, 1.0), 48192, 31754, 6544);
  expect_codes(settings(3.7, 2.2), 33021, 12208, 34);
  expect_codes(settings(3.7, {}, true), 32768, 13107, 655);
  expect_codes(settings(3.7, {}), 48192, 31754, 6544);
  expect_codes(settings(3.6, {}), 32768, 13107, 655);
  expect_codes(settings(3.6, 1.0), 48192, 31754, 6544);
  expect_codes(settings(3.6, 2.2), 33021, 12208, 34);
}

TEST(Transfer, makes_many_colours_linear_as_single_ones) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Rgb> some{Rgb(0),           Rgb(-0.0),        {0.5, 0.2, 0.01}, {0.5, 0.2, 0.01}, {0.5, 0.2, 0.02},
                              {0.5, 0.3, 0.02}, {0.4, 0.3, -0.2}, {nan, 0.3, 0.02}, {nan, 0.3, 0.02}, Rgb(0)};
  for (const scene::Settings& its : {settings(3.7, 1.0), settings(3.7, 2.2), settings(3.7, 0.0), settings(3.6, {})}) {
    const WorkingSpace space(its);
    for (const std::size_t count : {0, 1, 10, 63, 64, 65, 200}) {
      std::vector<Rgb> colours;
      while (colours.size() < count) colours.push_back(some[colours.size() % some.size()]);
      space.make_linear(colours);
      for (std::size_t k = 0; k < count; ++k) {
        const Rgb expected = space.to_linear(some[k % some.size()]);
        for (int i = 0; i < 3; ++i)
          EXPECT_EQ(std::bit_cast<std::uint64_t>(colours[k][i]), std::bit_cast<std::uint64_t>(expected[i])) << k;
      }
    }
  }
}

TEST(Transfer, srgb_goes_there_and_back) {
  for (int i = -100; i <= 300; ++i) {
    const double code = i / 100.0;
    EXPECT_NEAR(srgb_from_linear(linear_from_srgb(code)), code, 1e-7) << "the standard's constants meet to 7 digits";
  }
  EXPECT_NEAR(srgb_from_linear(0.5), 0.7353569830524495, 1e-12);
  EXPECT_NEAR(srgb_from_linear(1), 1, 1e-14);
}

TEST(Transfer, clips_what_a_display_cannot_show) {
  EXPECT_EQ(display_from_linear(-1), 0);
  EXPECT_NEAR(display_from_linear(7), 1, 1e-14);
  EXPECT_LE(display_from_linear(std::numeric_limits<double>::infinity()), 1);
  EXPECT_EQ(display_from_linear(std::numeric_limits<double>::quiet_NaN()), 0);
}

}  // namespace
}  // namespace isl::render::test
