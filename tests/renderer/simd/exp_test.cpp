// Our exponential, compared with MPFR.
#include "renderer/simd/exp-inl.h"

#include <gtest/gtest.h>
#include <boost/multiprecision/mpfr.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace isl::render {
namespace {

using Exact = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<60>>;
namespace lanes = HWY_NAMESPACE;

double ours(double y) {
  alignas(64) double out[lanes::kOctet];
  lanes::store(lanes::exp(lanes::Octet(y)), out);
  return out[3];
}

/// The relative error in units of 2⁻⁵³, which is the least half unit in the last place.
double error(double y) {
  const Exact exact = boost::multiprecision::exp(Exact(y));
  return static_cast<double>(boost::multiprecision::abs((Exact(ours(y)) - exact) / exact)) * 0x1p53;
}

TEST(Exp, IsWithinTwoUnitsInTheLastPlace) {
  std::mt19937_64 bits(7);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const double unit = static_cast<double>(bits() >> 11) * 0x1p-53;
    worst = std::max({worst, error(-700 + 1400 * unit), error(-1 + 2 * unit)});
  }
  EXPECT_LT(worst, 4) << "in units of 2^-53";
}

TEST(Exp, IsExactWhereTheAnswerIs) {
  EXPECT_EQ(ours(0), 1);
  EXPECT_EQ(ours(-0.0), 1);
}

TEST(Exp, IsZeroBelowItsRange) {
  EXPECT_EQ(ours(-709), 0);
  EXPECT_EQ(ours(-1e308), 0);
  EXPECT_EQ(ours(-HUGE_VAL), 0);
  EXPECT_GT(ours(-707), 0);
}

TEST(Exp, IsBoundedFromAbove) {
  std::mt19937_64 bits(8);
  double least = 1, greatest = 0;
  for (int i = 0; i < 200000; ++i) {
    const double y = -700 + 1400 * static_cast<double>(bits() >> 11) * 0x1p-53;
    alignas(64) double bound[lanes::kOctet];
    lanes::store(lanes::exp_above(lanes::Octet(y)), bound);
    const double above = bound[3] / std::exp(y) - 1;
    least = std::min(least, above);
    greatest = std::max(greatest, above);
  }
  EXPECT_GT(least, 1e-4);
  EXPECT_LT(greatest, lanes::kExpAbove * (1 + 1e-9));
}

TEST(Exp, SumsRunThroughOneTree) {
  alignas(64) const double x[lanes::kOctet] = {1e16, 1, -1e16, 1, 3, 1, -3, 1};
  EXPECT_EQ(lanes::sum(lanes::load(x)), ((x[0] + x[4]) + (x[2] + x[6])) + ((x[1] + x[5]) + (x[3] + x[7])));
}

TEST(Octet, FindsItsLeastAndItsGreatestNumber) {
  alignas(64) double x[lanes::kOctet] = {3, 1, 4, 2, 9, 2, 6, 5};
  for (std::size_t i = 0; i < lanes::kOctet; ++i) {
    x[i] -= 20;
    EXPECT_EQ(lanes::least(lanes::load(x)), *std::ranges::min_element(x));
    x[i] += 40;
    EXPECT_EQ(lanes::greatest(lanes::load(x)), *std::ranges::max_element(x));
  }
}

}  // namespace
}  // namespace isl::render
