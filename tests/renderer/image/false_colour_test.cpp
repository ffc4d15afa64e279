#include "renderer/image/false_colour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isl::render {
namespace {

/// Converts linear sRGB to OKLab by the published matrices.
Rgb oklab_of(const Rgb& c) {
  const double l = std::cbrt(0.4122214708 * c.x + 0.5363325363 * c.y + 0.0514459929 * c.z);
  const double m = std::cbrt(0.2119034982 * c.x + 0.6806995451 * c.y + 0.1073969566 * c.z);
  const double s = std::cbrt(0.0883024619 * c.x + 0.2817188376 * c.y + 0.6299787005 * c.z);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

TEST(FalseColours, AreDisplayable) {
  for (int i = 0; i <= 1000; ++i) {
    const Rgb c = false_colour(i / 1000.0);
    EXPECT_GE(std::min({c.x, c.y, c.z}), 0) << i;
    EXPECT_LE(std::max({c.x, c.y, c.z}), 1) << i;
  }
}

TEST(FalseColours, StepEvenlyAndOnlyGetLighter) {
  constexpr int kSteps = 200;
  double least = 1, most = 0;
  for (int i = 0; i < kSteps; ++i) {
    const Rgb from = oklab_of(false_colour(i / double{kSteps})), to = oklab_of(false_colour((i + 1) / double{kSteps}));
    EXPECT_GT(to.x, from.x) << i;
    const double step = (to - from).length();
    least = std::min(least, step);
    most = std::max(most, step);
  }
  EXPECT_LT(most / least, 1.1) << "a step across a corner of the path is shorter by its bend";
}

TEST(FalseColours, EndWhereTheScaleEnds) {
  EXPECT_EQ(false_colour(-3), false_colour(0));
  EXPECT_EQ(false_colour(std::numeric_limits<double>::quiet_NaN()), false_colour(0));
  EXPECT_EQ(false_colour(7), false_colour(1));
}

TEST(ColourScales, CountDifferencesOrRatios) {
  EXPECT_DOUBLE_EQ((ColourScale{10, 20, false}).share_of(15), 0.5);
  EXPECT_DOUBLE_EQ((ColourScale{1e-4, 1e2, true}).share_of(0.1), 0.5);
  EXPECT_EQ((ColourScale{1e-4, 1e2, true}).share_of(0), 0);
}

}  // namespace
}  // namespace isl::render
