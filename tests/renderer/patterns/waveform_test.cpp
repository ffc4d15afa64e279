// The sine of a turn against the library's in extended precision.
#include "renderer/patterns/kinds/waveform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace isl::render {
namespace {

TEST(Waveform, cycloidal_is_the_sine_of_the_turn_to_two_units_in_the_last_place) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> turns(-1, 1), octaves(-30, 20);
  long double worst = 0;
  for (int i = 0; i < 1000000; ++i) {
    const double value = turns(random) * std::exp2(octaves(random));
    const long double size = std::abs(static_cast<long double>(value)), within = size - std::floor(size);
    // The turn is taken to the nearest half first, so that the extended product loses nothing where the sine is small.
    const long double half = std::round(2 * within) / 2, sign = half == 0.5L ? -1 : 1;
    const long double sine =
        std::copysign(1.0L, value) * sign * std::sin(2 * std::numbers::pi_v<long double> * (within - half));
    if (sine == 0) {
      ASSERT_EQ(cycloidal(value), 0) << value;
    } else {
      worst = std::max(worst, std::abs((cycloidal(value) - sine) / sine));
    }
  }
  EXPECT_LT(worst, 2 * 0x1p-52L);
}

TEST(Waveform, cycloidal_is_exact_at_quarters_of_a_turn) {
  for (const double turn : {0.0, 1.0, 1e6}) {
    EXPECT_EQ(cycloidal(turn), 0);
    EXPECT_EQ(cycloidal(turn + 0.5), 0);
    EXPECT_EQ(cycloidal(turn + 0.25), 1);
    EXPECT_EQ(cycloidal(turn + 0.75), -1);
    EXPECT_EQ(cycloidal(-turn - 0.25), -1);
  }
}

}  // namespace
}  // namespace isl::render
