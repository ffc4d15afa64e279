// gtest's EXPECT_NEAR compares in double, but the reference's tests need all 64 bits of a long double.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>
#include <limits>

namespace isl::reference {

[[nodiscard]] inline testing::AssertionResult is_close(const char* actual_text, const char* expected_text, const char*,
                                                       long double actual, long double expected,
                                                       long double tolerance) {
  const long double difference = std::abs(actual - expected);
  if (difference <= tolerance) return testing::AssertionSuccess();
  testing::AssertionResult failure = testing::AssertionFailure();
  failure << std::setprecision(std::numeric_limits<long double>::max_digits10) << actual_text << " is " << actual
          << ", " << expected_text << " is " << expected << ": off by " << difference << ", more than " << tolerance;
  return failure;
}

}  // namespace isl::reference

#define EXPECT_CLOSE(actual, expected, tolerance) \
  EXPECT_PRED_FORMAT3(::isl::reference::is_close, actual, expected, tolerance)
#define ASSERT_CLOSE(actual, expected, tolerance) \
  ASSERT_PRED_FORMAT3(::isl::reference::is_close, actual, expected, tolerance)
