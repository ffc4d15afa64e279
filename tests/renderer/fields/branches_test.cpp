#include "renderer/fields/branches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <vector>

namespace isl::render {
namespace {

using Sets = std::vector<std::vector<std::uint32_t>>;

Sets sorted(Sets sets) {
  for (std::vector<std::uint32_t>& set : sets) std::ranges::sort(set);
  std::ranges::sort(sets);
  return sets;
}

/// 1, 2, 3 are alternatives in the blob's own sum, and so are 4, 5; inside 2 are 6 and 7.
constexpr std::array<scene::Branch, 8> kTree = {{{0, 0}, {0, 1}, {0, 1}, {0, 1}, {0, 4}, {0, 4}, {2, 6}, {2, 6}}};

TEST(BranchTree, AddsTheGreatestOfEachMaximum) {
  std::vector<double> values = {10, 1, 2, -5, -1, -2, 0.5, 0.25};
  BranchTree(kTree).add_up(values);
  EXPECT_EQ(values[2], 2.5);
  EXPECT_EQ(values[0], 10 + 2.5 - 1);
}

TEST(BranchTree, SelectsOneBranchOfEveryMaximum) {
  std::vector<FieldRange> ranges(8, {0, 1});
  EXPECT_EQ(sorted(BranchTree(kTree).selections(ranges)),
            (Sets{{0, 1, 4}, {0, 1, 5}, {0, 2, 4, 6}, {0, 2, 4, 7}, {0, 2, 5, 6}, {0, 2, 5, 7}, {0, 3, 4}, {0, 3, 5}}));
}

TEST(BranchTree, LeavesOutWhatIsBeaten) {
  std::vector<FieldRange> ranges(8, {0, 0});
  ranges[1] = {0.5, 1};
  ranges[3] = {0.2, 0.4};  // less than 1 everywhere, like 2 with 6 and 7, which have no field here
  ranges[4] = {-2, -1};    // less than 5, which has no field here
  EXPECT_EQ(BranchTree(kTree).selections(ranges), (Sets{{0, 1}}));
  ranges[4] = {-2, 1};
  EXPECT_EQ(sorted(BranchTree(kTree).selections(ranges)), (Sets{{0, 1}, {0, 1, 4}}));
}

TEST(BranchTree, KnowsHowManySelectionsThereCanBe) {
  const BranchTree tree(kTree);
  EXPECT_EQ(tree.most_selections(std::vector<bool>(8, true)), 8U);
  EXPECT_EQ(tree.most_selections(std::vector<bool>(8, false)), 1U);
  std::mt19937 random(6);
  for (int repeat = 0; repeat < 256; ++repeat) {
    std::vector<FieldRange> ranges(8, {0, 0});
    std::vector<bool> is_there(8, false);
    for (std::size_t b = 1; b < 8; ++b) {
      if (random() % 2 == 0) continue;
      is_there[b] = true;
      ranges[b] = {-1, 1};
    }
    EXPECT_LE(tree.selections(ranges).size(), tree.most_selections(is_there));
  }
}

TEST(BranchTree, OneOfItsSelectionsIsTheGreatestWhateverTheValues) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> value(-1, 1);
  const BranchTree tree(kTree);
  for (int repeat = 0; repeat < 1000; ++repeat) {
    std::vector<FieldRange> ranges(8);
    std::vector<double> values(8);
    for (std::size_t b = 0; b < 8; ++b) {
      const double a = value(random), c = value(random);
      ranges[b] = random() % 3 == 0 ? FieldRange{0, 0} : FieldRange{std::min(a, c), std::max(a, c)};
      values[b] = ranges[b].low + (ranges[b].high - ranges[b].low) * 0.5 * (1 + value(random));
    }
    double greatest = -std::numeric_limits<double>::infinity();
    for (const std::vector<std::uint32_t>& selection : tree.selections(ranges)) {
      double sum = 0;
      for (const std::uint32_t b : selection) sum += values[b];
      greatest = std::max(greatest, sum);
    }
    tree.add_up(values);
    ASSERT_NEAR(greatest, values[0], 1e-15);
  }
}

}  // namespace
}  // namespace isl::render
