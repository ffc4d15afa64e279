// AxialRange holds all corners of a box, for axes of all signs: one corner left out is a hole in the picture.
#include "renderer/fields/skeletons/skeleton.h"
#include "tests/reference/random_scenes.h"

#include <gtest/gtest.h>

namespace isl::render {
namespace {

TEST(AxialRange, HoldsEveryCorner) {
  reference::RandomSource random(5);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 centre = random.in_ball(2), axis = random.direction(), at = random.in_ball(2);
    const Vec3 half(random.unit(), random.unit(), random.unit());
    const AxialRange range(Box(centre - half, centre + half), at, axis);
    for (unsigned corner = 0; corner < 8; ++corner) {
      const auto side = [&](int k) { return (corner >> k & 1U) != 0 ? half[k] : -half[k]; };
      const Vec3 from = centre + Vec3(side(0), side(1), side(2)) - at;
      const double x = from.dot(axis), rho = (from - axis * x).length();
      // The tolerance is some units in the last place of numbers up to 6.
      EXPECT_LE(range.x_low, x + 1e-14);
      EXPECT_GE(range.x_high, x - 1e-14);
      EXPECT_LE(range.rho_low, rho + 1e-14);
      EXPECT_GE(range.rho_high, rho - 1e-14);
    }
  }
}

}  // namespace
}  // namespace isl::render
