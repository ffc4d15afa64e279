#include "renderer/queries/branch_sums.h"

#include "renderer/fields/branches.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace isl::render {
namespace {

TEST(BranchSums, AddUpToTheFieldOfTheWholeTree) {
  std::mt19937 random(7);
  for (int repeat = 0; repeat < 300; ++repeat) {
    // A random tree: every branch joins the maximum before it, or begins one.
    std::vector<scene::Branch> branches{{0, 0}};
    const auto count = 2 + static_cast<std::uint32_t>(random() % 40);
    for (std::uint32_t b = 1; b < count; ++b) {
      const bool joins = b > 1 && random() % 3 != 0;
      branches.push_back(joins ? branches.back() : scene::Branch{static_cast<std::uint32_t>(random() % b), b});
    }
    std::vector<double> values(count, 0);
    std::vector<BranchSums::Sum> sums;
    for (std::uint32_t b = 0; b < count; ++b) {
      if (random() % 3 != 0) continue;
      values[b] = std::ldexp(static_cast<double>(random()), -31) - 1;
      sums.push_back({b, values[b]});
    }
    BranchTree(branches).add_up(values);
    EXPECT_EQ(BranchSums(branches).field(sums), values[0]) << repeat;
  }
}

TEST(BranchSums, OfABlobWithoutMaximaAreItsSum) {
  const std::array<BranchSums::Sum, 1> one{{{0, 0.5}}};
  EXPECT_EQ(BranchSums({}).field(one), 0.5);
  EXPECT_EQ(BranchSums({}).field({}), 0);
}

}  // namespace
}  // namespace isl::render
