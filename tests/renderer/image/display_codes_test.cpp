// The codes of integer files equal those of the curve, value by value.
#include "renderer/image/display_codes.h"
#include "renderer/image/transfer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace isl::render::test {
namespace {

void expect_code(const DisplayCodes& codes, int most, double linear) {
  ASSERT_EQ(codes(linear), std::floor(display_from_linear(linear) * most + 0.5)) << most << " codes, " << linear;
}

TEST(DisplayCodes, are_those_of_the_curve_wherever_two_codes_meet) {
  for (const int most : {1, 255, 65535}) {
    const DisplayCodes codes(most);
    for (int code = 0; code < most; ++code) {
      const double border = linear_from_srgb((code + 0.5) / most);
      for (const double part : {-1e-6, -1e-9, -1e-13, 0.0, 1e-13, 1e-9, 1e-6})
        expect_code(codes, most, border * (1 + part));
    }
  }
}

TEST(DisplayCodes, are_those_of_the_curve_at_random_values) {
  const DisplayCodes eight(255), sixteen(65535);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-0.1, 1.1), exponent(-12, 1);
  for (int i = 0; i < 200'000; ++i) {
    for (const double linear : {uniform(random), std::exp2(exponent(random))}) {
      expect_code(eight, 255, linear);
      expect_code(sixteen, 65535, linear);
    }
  }
}

TEST(DisplayCodes, are_clipped) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const DisplayCodes codes(65535);
  for (const double linear : {-kInfinite, -1.0, -0.0, 0.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(codes(linear), 0u);
  for (const double linear : {std::nextafter(1.0, 0.0), 1.0, 2.0, kInfinite}) EXPECT_EQ(codes(linear), 65535u);
  for (double octave = 0x1p-10; octave <= 1; octave *= 2) {
    for (const double linear : {std::nextafter(octave, 0.0), octave, std::nextafter(octave, 2.0)})
      expect_code(codes, 65535, linear);
  }
}

}  // namespace
}  // namespace isl::render::test
