// Cubics in Bernstein form.
#include "renderer/numerics/cubic.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace isl::render {
namespace {

using BernsteinCubic = std::array<double, 4>;

/// −(u − p)(u − q)(u − r) · sign in Bernstein form, by blossoming.
BernsteinCubic with_roots(double p, double q, double r, double sign) {
  const auto blossom = [&](double a, double b, double c) {
    const double terms = (a - p) * (b - q) * (c - r) + (a - p) * (b - r) * (c - q) + (a - q) * (b - p) * (c - r) +
                         (a - q) * (b - r) * (c - p) + (a - r) * (b - p) * (c - q) + (a - r) * (b - q) * (c - p);
    return sign * terms / 6;
  };
  return {blossom(0, 0, 0), blossom(0, 0, 1), blossom(0, 1, 1), blossom(1, 1, 1)};
}

double first_crossing(const BernsteinCubic& b) { return first_crossing_of_cubic(b[0], b[1], b[2], b[3]); }

TEST(Cubic, FindsTheFirstOfThreeRoots) {
  const BernsteinCubic b = with_roots(0.2, 0.5, 0.9, 1);
  ASSERT_LT(b[0], 0);
  EXPECT_NEAR(first_crossing(b), 0.2, 1e-14);
}

TEST(Cubic, FindsOneOfACloseTripleAndNeverHalfAPair) {
  for (const double gap : {1e-3, 1e-6, 1e-8}) {
    const double u = first_crossing(with_roots(0.5, 0.5 + gap, 0.9, 1));
    // The pair is found as a whole or dropped as a whole; in the latter case the single root remains.
    EXPECT_TRUE(std::abs(u - 0.5) <= 2 * gap || std::abs(u - 0.9) < 1e-12) << gap << ' ' << u;
  }
}

TEST(Cubic, LinesAndParabolasAreCubicsToo) {
  EXPECT_NEAR(first_crossing({-1, -1.0 / 3, 1.0 / 3, 1}), 0.5, 1e-15);
  // u² − ¼, raised to a cubic.
  EXPECT_NEAR(first_crossing({-0.25, -0.25, -0.25 + 1.0 / 3, 0.75}), 0.5, 1e-15);
}

TEST(Cubic, HasNoCrossingWhereItStaysBelow) {
  EXPECT_GT(first_crossing({-1, -1, -1, -1}), 1);
  EXPECT_GT(first_crossing(with_roots(1.5, 2, 3, 1)), 1);
  EXPECT_GT(first_crossing({-1e-320, -1e-320, -1e-320, -1e-320}), 1);
}

TEST(Cubic, CrossingsDoNotDependOnTheScaleOfValues) {
  const BernsteinCubic b = with_roots(0.3, 0.31, 0.8, 1);
  const double u = first_crossing(b);
  for (const double scale : {0x1p300, 0x1p-300}) {
    EXPECT_EQ(first_crossing({b[0] * scale, b[1] * scale, b[2] * scale, b[3] * scale}), u);
  }
}

TEST(Cubic, FirstGuessIsCloseToTheRoot) {
  const BernsteinCubic b = with_roots(0.37, 3, 4, 1);
  EXPECT_NEAR(root_of_rising_cubic(b[0], b[1], b[2], b[3]), 0.37, 1e-6);
}

}  // namespace
}  // namespace isl::render
