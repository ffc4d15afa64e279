#include "base/stop_flag.h"

#include <gtest/gtest.h>

namespace isl {
namespace {

TEST(StopFlag, KeepsTheFirstReason) {
  StopFlag flag;
  EXPECT_FALSE(flag.is_set());
  EXPECT_TRUE(flag.set(StopReason::time_over));
  EXPECT_FALSE(flag.set(StopReason::interrupt));
  EXPECT_EQ(flag.reason(), StopReason::time_over);
}

TEST(StepCounter, GrantsAsManyStepsAsItsLimit) {
  for (const std::uint64_t limit : {0u, 1u, 4095u, 4096u, 4097u, 10000u}) {
    StepCounter one_by_one(limit);
    std::uint64_t taken = 0;
    while (one_by_one.take()) ++taken;
    EXPECT_EQ(taken, limit);
    EXPECT_TRUE(one_by_one.is_spent());
    EXPECT_FALSE(one_by_one.take()) << "it stays spent";
    StepCounter together(limit);
    EXPECT_TRUE(together.take(limit));
    EXPECT_FALSE(together.is_spent());
    EXPECT_FALSE(together.take());
  }
}

TEST(StepCounter, CountsSeveralStepsAsIfTheyWereTakenOneByOne) {
  StepCounter steps(100'000);
  std::uint64_t taken = 0;
  for (std::uint64_t some = 0; steps.take(some); some = (some * 7 + 13) % 9001) taken += some;
  EXPECT_LE(taken, 100'000u);
  EXPECT_GT(taken, 100'000u - 9001);
  StepCounter none(0);
  EXPECT_TRUE(none.take(0));
  EXPECT_FALSE(none.take(StepCounter::kUnlimited));
}

TEST(StepCounter, SeesTheFlagWithinItsNumberOfSteps) {
  StopFlag flag;
  StepCounter steps(StepCounter::kUnlimited, &flag);
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(steps.take());
  flag.set(StopReason::interrupt);
  std::uint64_t taken = 0;
  while (steps.take()) ++taken;
  EXPECT_LT(taken, StepCounter::kStepsBetweenLooks);
  EXPECT_TRUE(steps.is_spent());
}

TEST(StepCounter, MayBeSpentByItsOwner) {
  StepCounter steps;
  steps.spend();
  EXPECT_FALSE(steps.take());
  EXPECT_TRUE(steps.is_spent());
}

}  // namespace
}  // namespace isl
