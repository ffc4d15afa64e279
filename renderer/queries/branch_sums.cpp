#include "renderer/queries/branch_sums.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace isl::render {

BranchSums::BranchSums(std::span<const scene::Branch> branches) : branches_(branches), rivals_(branches.size(), 0) {
  for (std::size_t b = 1; b < branches.size(); ++b) ++rivals_[branches[b].maximum];
}

double BranchSums::field(std::span<const Sum> sums) const {
  if (branches_.empty()) return sums.empty() ? 0 : sums.front().value;
  // By maximum and branch. What lies inside a branch has greater numbers, so that the branches of the last maximum are
  // complete.
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> open;
  const auto add = [&](std::uint32_t branch, double value) {
    open[{branch == 0 ? 0 : branches_[branch].maximum, branch}] += value;
  };
  for (const Sum& sum : sums) add(sum.branch, sum.value);
  while (!open.empty()) {
    const std::uint32_t maximum = open.rbegin()->first.first;
    if (maximum == 0) return open.rbegin()->second;
    std::uint32_t count = 0;
    double greatest = -std::numeric_limits<double>::infinity();
    for (; !open.empty() && open.rbegin()->first.first == maximum; open.erase(std::prev(open.end()))) {
      greatest = std::max(greatest, open.rbegin()->second);
      ++count;
    }
    if (count < rivals_[maximum]) greatest = std::max(greatest, 0.0);
    add(branches_[maximum].parent, greatest);
  }
  return 0;
}

}  // namespace isl::render
