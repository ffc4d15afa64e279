#include "base/budget.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <thread>
#include <utility>
#include <vector>

namespace isl {
namespace {

constexpr std::size_t kLimit = 1'000'000;
constexpr std::size_t kMost = std::numeric_limits<std::size_t>::max();

TEST(Budget, GrantsUpToItsLimitAndNoByteMore) {
  Budget budget(kLimit);
  EXPECT_TRUE(budget.take(kLimit - 1));
  EXPECT_FALSE(budget.take(2));
  EXPECT_FALSE(budget.take(kMost));
  EXPECT_TRUE(budget.take(1));
  EXPECT_EQ(budget.left(), 0u);
  budget.give_back(10);
  EXPECT_TRUE(budget.take(10));
}

TEST(Budget, IsExactWhenThreadsTakeFromIt) {
  Budget budget(kLimit);
  std::atomic<std::size_t> granted = 0;
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i) {
      threads.emplace_back([&] {
        while (budget.take(7)) granted += 7;
      });
    }
  }
  EXPECT_EQ(granted, kLimit / 7 * 7);
  EXPECT_EQ(budget.held(), granted);
}

TEST(Charge, CountsBytesAndReturnsThemWhenItDies) {
  Budget budget(kLimit);
  {
    Charge charge(&budget);
    EXPECT_TRUE(charge.grow(1000));
    EXPECT_TRUE(charge.grow(2000));
    EXPECT_EQ(charge.bytes(), 3000u);
    EXPECT_GE(budget.held(), 3000u);
    EXPECT_LE(budget.held(), 6000u) << "an owner of little takes little in advance";
    EXPECT_FALSE(charge.grow(kLimit));
    EXPECT_FALSE(charge.grow(kMost)) << "the sum does not overflow";
    EXPECT_EQ(charge.bytes(), 3000u) << "nothing of what was refused is counted";
  }
  EXPECT_EQ(budget.held(), 0u);
}

TEST(Charge, GrantsTheLastBytesOfTheBudget) {
  Budget budget(kLimit);
  Charge charge(&budget);
  std::size_t granted = 0;
  while (charge.grow(1)) ++granted;
  EXPECT_EQ(granted, kLimit);
}

TEST(Charge, GivesBackWhatIsFreedForOthers) {
  Budget budget(100 * kLimit);
  Charge charge(&budget);
  ASSERT_TRUE(charge.grow(99 * kLimit));
  Charge other(&budget);
  EXPECT_FALSE(other.grow(50 * kLimit));
  charge.remove(98 * kLimit);
  EXPECT_TRUE(other.grow(50 * kLimit));
  EXPECT_TRUE(charge.grow(kLimit));
}

TEST(Charge, TakesWhatWasAddedUnaskedAtTheNextRequest) {
  Budget budget(kLimit);
  Charge charge(&budget);
  charge.add(kLimit / 2);
  EXPECT_TRUE(charge.make_room(10));
  EXPECT_GE(budget.held(), kLimit / 2 + 10);
  charge.add(kLimit);
  EXPECT_FALSE(charge.make_room(0)) << "more is held than is allowed";
  charge.remove(kLimit);
  EXPECT_TRUE(charge.make_room(0));
}

TEST(Charge, MovesWithItsOwner) {
  Budget budget(kLimit);
  Charge charge(&budget);
  ASSERT_TRUE(charge.grow(1000));
  Charge moved = std::move(charge);
  EXPECT_EQ(moved.bytes(), 1000u);
  moved = Charge(&budget);
  EXPECT_EQ(moved.bytes(), 0u);
  EXPECT_EQ(budget.held(), 0u) << "what it held before is given back";
}

TEST(Charge, GrantsEverythingWithoutABudget) {
  Charge charge;
  EXPECT_TRUE(charge.grow(std::size_t{1} << 60));
  EXPECT_TRUE(charge.make_room(std::size_t{1} << 60));
}

}  // namespace
}  // namespace isl
