// Tilings: facts that follow from their definition. The values are compared with POV-Ray's in tests/povray/probes/.
#include "renderer/patterns/kinds/penrose.h"
#include "renderer/patterns/kinds/periodic_polygons.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace isl::render {
namespace {

using scene::Vec3;

double tiling(int number, const Vec3& p) {
  switch (number) {
    case 25: return penrose_pentagons(p);
    case 26: return penrose_kites(p);
    case 27: return penrose_rhombs(p);
    default: return periodic_polygons(number, p);
  }
}

TEST(Tilings, ChangeNoFasterThanTheirBordersReachButAtBorders) {
  // Along a line the value goes down from a border, and up to the next: between two samples it falls or rises by the
  // slope, at most 4.46, unless they lie in two tiles, whose border is 1 for its kind.
  constexpr double kStep = 0.001, kSteepest = 4.46;
  for (int number = 1; number <= 27; ++number) {
    double before = tiling(number, {-4, 0, 0.317});
    int jumps = 0;
    for (double x = -4 + kStep; x < 4; x += kStep) {
      const double now = tiling(number, {x, 0, 0.317 + 0.211 * x});
      ASSERT_GE(now, 0);
      ASSERT_LE(now, 1 + 1e-6);  // the most by which POV-Ray lifts the values of a kind of tiles
      if (std::abs(now - before) > kSteepest * kStep * 1.1) ++jumps;
      before = now;
    }
    EXPECT_LT(jumps, 60) << number;
  }
}

TEST(Tilings, PenrosesHaveFiveMirrorsAboutTheOrigin) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-300, 300);
  for (const int number : {25, 26, 27}) {
    for (int i = 0; i < 300; ++i) {
      const Vec3 p(coordinate(random), 0, coordinate(random));
      const double angle = 2 * std::numbers::pi / 5, cosine = std::cos(angle), sine = std::sin(angle);
      const Vec3 turned(p.x * cosine - p.z * sine, 0, p.x * sine + p.z * cosine);
      EXPECT_NEAR(tiling(number, turned), tiling(number, p), 1e-10) << number;
      EXPECT_NEAR(tiling(number, {p.x, 0, -p.z}), tiling(number, p), 1e-10) << number;
    }
  }
}

TEST(Tilings, PenrosesNumbersOfTilesAreInTheGoldenRatio) {
  // By area: of kites to darts φ : 1 in number and φ : 1 in area each; of wide rhombs to narrow ones likewise.
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-2000, 2000);
  constexpr int kSamples = 200000;
  for (const int number : {26, 27}) {
    int first = 0;
    for (int i = 0; i < kSamples; ++i)
      first += tiling(number, {coordinate(random), 0, coordinate(random)}) < 0.5 ? 1 : 0;
    const double share = std::numbers::phi * std::numbers::phi / (std::numbers::phi * std::numbers::phi + 1);
    // Four standard deviations of the count.
    EXPECT_NEAR(first / static_cast<double>(kSamples), share, 4 * std::sqrt(share * (1 - share) / kSamples)) << number;
  }
}

}  // namespace
}  // namespace isl::render
