// power() and exponential(), compared with the C library in long double.
#include "renderer/numerics/power.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace isl::render::test {
namespace {

TEST(Power, agrees_with_the_c_library) {
  for (const double y : {-2.5, -1.0, 1 / 2.4, 0.5, 1.0, 2.0, 2.2, 2.4, 7.5, 20.0, 40.0, 64.0, 65.0, 250.0, 5000.0}) {
    for (int i = 1; i < 4000; ++i) {
      const double x = i / 2000.0;
      const long double expected = std::pow(static_cast<long double>(x), static_cast<long double>(y));
      if (expected < 1e-300L || expected > 1e300L) continue;
      const long double bound = 1e-14L * (1 + std::abs(y * std::log2(static_cast<long double>(x))) / 40);
      ASSERT_LE(std::abs(power(x, y) / expected - 1), bound) << x << "^" << y;
    }
  }
}

TEST(Powers, are_those_of_single_numbers) {
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> x, y;
  for (const double base : {0.0, 1e-320, 0.3, 0.999, 1.0, 1.7, 1e300, infinity}) {
    for (const double exponent : {-2.5, 0.0, 1.0, 40.0, 63.5, 64.0, 65.0, 1000.0, 5e6, infinity}) {
      x.push_back(base);
      y.push_back(exponent);
    }
  }
  std::vector<double> found(x.size());
  powers(x, y, found);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_EQ(found[i], power(x[i], y[i])) << x[i] << "^" << y[i];
  const std::vector<double> bad = {std::numeric_limits<double>::quiet_NaN(), -1};
  powers(bad, std::vector<double>{2, 0.5}, found = {0, 0});
  EXPECT_TRUE(std::isnan(found[0]) && std::isnan(found[1]));
}

TEST(Exponential, agrees_with_the_c_library) {
  for (int i = -30000; i <= 30000; ++i) {
    const double x = i / 43.0;
    const long double bound = 1e-14L * (1 + std::abs(x) / 27);
    ASSERT_LE(std::abs(exponential(x) / std::exp(static_cast<long double>(x)) - 1), bound) << x;
  }
  EXPECT_EQ(exponential(0), 1);
  EXPECT_EQ(exponential(-1e10), 0);
  EXPECT_EQ(exponential(-std::numeric_limits<double>::infinity()), 0);
  EXPECT_EQ(exponential(1e10), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(exponential(std::numeric_limits<double>::quiet_NaN())));
}

TEST(Power, has_the_limits_of_pow) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(power(0, 0), 1);
  EXPECT_EQ(power(0, 0.5), 0);
  EXPECT_EQ(power(0, -1), infinity);
  EXPECT_EQ(power(1, 1e9), 1);
  EXPECT_EQ(power(0.5, 1e9), 0);
  EXPECT_EQ(power(2, 1e9), infinity);
  EXPECT_EQ(power(infinity, 0.4), infinity);
  EXPECT_TRUE(std::isnan(power(-1, 0.5)));
  EXPECT_TRUE(std::isnan(power(std::numeric_limits<double>::quiet_NaN(), 2)));
  EXPECT_GT(power(0.5, 1070), 0) << "a denormal number";
}

}  // namespace
}  // namespace isl::render::test
