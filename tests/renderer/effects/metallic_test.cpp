#include "renderer/shading/metal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace isl::render::test {
namespace {

TEST(RightAngles, AreTheArcCosineToTheBoundOfTheFormula) {
  for (int i = 0; i <= 10'000; ++i) {
    const double x = i / 10'000.0;
    EXPECT_NEAR(right_angles(x) * (std::numbers::pi / 2), std::acos(x), 2.2e-8) << x;
  }
}

TEST(MetallicTint, IsTheColourHeadOnAndWhiteAtGrazingAngles) {
  const Rgb colour(0.2, 0.4, 0.6);
  EXPECT_NEAR(metal_tint(1, 1, colour).x, 0.2, 1e-6);
  EXPECT_NEAR(metal_tint(1, 0, colour).x, 1, 1e-6);
  EXPECT_NEAR(metal_tint(0.5, 1, colour).z, 0.8, 1e-6);
  EXPECT_EQ(metal_tint(0, 0.3, colour), Rgb(1));
}

TEST(MetallicTint, FallsWhereBumpsTurnTheNormalAwayAsInPovray) {
  EXPECT_NEAR(metal_tint(1, -0.1, Rgb(0)).x, 1, 1e-6);
  EXPECT_NEAR(metal_tint(1, -0.6395, Rgb(0)).x, 0.1291, 1e-4);
}

}  // namespace
}  // namespace isl::render::test
