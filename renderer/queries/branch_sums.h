// A blob's field at a point from the sums of the few branches that have components there (fields/branches.h adds up all
// of them).
#pragma once

#include "renderer/scene/fields.h"

#include <cstdint>
#include <span>
#include <vector>

namespace isl::render {

class BranchSums {
 public:
  /// `branches` are those of a blob, which outlives this.
  explicit BranchSums(std::span<const scene::Branch> branches);

  struct Sum {
    std::uint32_t branch;
    double value;
  };
  /// The field, as BranchTree::add_up() has it to the last digit. The sums of all other branches are 0. It takes as
  /// long as there are sums, however many branches there are.
  [[nodiscard]] double field(std::span<const Sum> sums) const;

  /// Bytes for a blob of so many branches.
  [[nodiscard]] static std::size_t bytes(std::size_t branches) { return branches * sizeof(std::uint32_t); }

 private:
  std::span<const scene::Branch> branches_;
  std::vector<std::uint32_t> rivals_;  ///< by maximum: how many branches it has
};

}  // namespace isl::render
