#include "renderer/fields/branches.h"

#include "base/check.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace isl::render {

BranchTree::BranchTree(std::span<const scene::Branch> branches)
    : branches_(branches.begin(), branches.end()), maxima_of_(branches.size()), branches_of_(branches.size()) {
  for (std::uint32_t b = 1; b < size(); ++b) {
    const scene::Branch& branch = branches_[b];
    ISL_CHECK(branch.parent < b && branch.maximum <= b && branch.maximum > branch.parent, "{} {} {}", b, branch.parent,
              branch.maximum);
    if (branch.maximum == b) maxima_of_[branch.parent].push_back(b);
    branches_of_[branch.maximum].push_back(b);
  }
}

void BranchTree::add_up(std::span<double> values) const {
  // Children have greater numbers than their parents, so this loop visits children first. A maximum has the number of
  // its first branch, which is the last of its branches to be visited.
  for (std::uint32_t b = size(); b-- > 1;) {
    if (branches_[b].maximum != b) continue;
    double greatest = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t sibling : branches_of_[b]) greatest = std::max(greatest, values[sibling]);
    values[branches_[b].parent] += greatest;
  }
}

std::vector<std::vector<std::uint32_t>> BranchTree::selections(std::span<const FieldRange> sums) const {
  std::vector<double> low(sums.size()), high(sums.size());
  for (std::size_t b = 0; b < sums.size(); ++b) {
    low[b] = sums[b].low;
    high[b] = sums[b].high;
  }
  add_up(low);
  add_up(high);
  return selections_of(0, low, high);
}

std::size_t BranchTree::most_selections(std::vector<bool> is_there) const {
  // Numbers of children are greater than those of their parents, so this loop visits children first.
  std::vector<std::size_t> ways(size(), 1);
  for (std::uint32_t b = size(); b-- > 0;) {
    for (const std::uint32_t maximum : maxima_of_[b]) {
      std::size_t options = 0;
      bool may_be_none = false;  // all branches without components count as one option
      for (const std::uint32_t option : branches_of_[maximum]) {
        if (is_there[option]) {
          options += ways[option];
          is_there[b] = true;
        } else {
          may_be_none = true;
        }
      }
      ways[b] *= options + (may_be_none ? 1 : 0);
    }
  }
  return ways[0];
}

BranchTree::Sets BranchTree::selections_of(std::uint32_t branch, std::span<const double> low,
                                           std::span<const double> high) const {
  Sets sets = {{branch}};
  for (const std::uint32_t maximum : maxima_of_[branch]) {
    // The branches that may be the greatest. All branches whose field is zero are equal: kNoBranch stands for them.
    constexpr std::uint32_t kNoBranch = 0;
    std::vector<std::uint32_t> rivals;
    for (const std::uint32_t b : branches_of_[maximum]) {
      const std::uint32_t rival = low[b] == 0 && high[b] == 0 ? kNoBranch : b;
      if (rival != kNoBranch || std::ranges::find(rivals, kNoBranch) == rivals.end()) rivals.push_back(rival);
    }
    const auto low_of = [&](std::uint32_t b) { return b == kNoBranch ? 0 : low[b]; };
    const auto high_of = [&](std::uint32_t b) { return b == kNoBranch ? 0 : high[b]; };
    Sets options;
    for (std::size_t i = 0; i < rivals.size(); ++i) {
      const auto is_beaten_by = [&](std::size_t j) {
        if (i == j || high_of(rivals[i]) > low_of(rivals[j])) return false;
        const bool is_mutual = high_of(rivals[j]) <= low_of(rivals[i]);
        return !is_mutual || j < i;
      };
      bool is_beaten = false;
      for (std::size_t j = 0; j < rivals.size(); ++j) is_beaten = is_beaten || is_beaten_by(j);
      if (is_beaten) continue;
      if (rivals[i] == kNoBranch) {
        options.push_back({});
      } else {
        std::ranges::copy(selections_of(rivals[i], low, high), std::back_inserter(options));
      }
    }
    Sets combined;
    for (const std::vector<std::uint32_t>& set : sets) {
      for (const std::vector<std::uint32_t>& option : options) {
        combined.push_back(set);
        combined.back().insert(combined.back().end(), option.begin(), option.end());
      }
    }
    sets = std::move(combined);
  }
  return sets;
}

}  // namespace isl::render
