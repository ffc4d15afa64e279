#include "base/growing_array.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace isl {
namespace {

TEST(GrowingArray, HoldsWhatAVectorHolds) {
  GrowingArray<int> array;
  std::vector<int> expected(100000);
  std::iota(expected.begin(), expected.end(), 0);
  for (const int i : expected) array.push_back(i);
  EXPECT_EQ(std::vector<int>(array.begin(), array.end()), expected);
  EXPECT_EQ(array.back(), 99999);
}

TEST(GrowingArray, TakesARecordOfItsOwn) {
  GrowingArray<int> array{7};
  for (int i = 0; i < 1000; ++i) array.push_back(array[0]);
  for (const int record : array) EXPECT_EQ(record, 7);
}

TEST(GrowingArray, CopiesAreApartAndMovesLeaveNothing) {
  GrowingArray<int> a{1, 2, 3};
  GrowingArray<int> b = a;
  b[0] = 9;
  EXPECT_EQ(a[0], 1);
  const GrowingArray<int> c = std::move(b);
  EXPECT_EQ(c.size(), 3u);
  EXPECT_TRUE(b.empty());  // NOLINT(bugprone-use-after-move): that is the claim
  a = a;
  EXPECT_EQ(a.size(), 3u);
}

TEST(GrowingArray, ResizesWithNewRecords) {
  GrowingArray<int> array{5};
  array.resize(3);
  EXPECT_EQ(std::vector<int>(array.begin(), array.end()), (std::vector<int>{5, 0, 0}));
  array.resize(1);
  EXPECT_EQ(array.size(), 1u);
}

}  // namespace
}  // namespace isl
