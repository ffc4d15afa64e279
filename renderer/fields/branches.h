// A blob as a tree of sums and maxima (scene::Branch), evaluated from the sums of each branch's own components.
//
// At a point, a maximum of sums has the value of a single branch. A sum is smooth, but a maximum has creases where the
// greatest branch changes. So where several branches can be the greatest, the blob is treated as the maximum of its
// *selections*. A selection takes one branch for each maximum, or none if a branch without a component nearby (its
// field is zero) can be the greatest.
#pragma once

#include "renderer/scene/fields.h"

#include <cstdint>
#include <span>
#include <vector>

namespace isl::render {

/// Range of a field over a box: least and greatest value.
struct FieldRange {
  double low, high;
};

class BranchTree {
 public:
  BranchTree() = default;
  explicit BranchTree(std::span<const scene::Branch> branches);

  /// Number of branches; 0 if the blob is a single sum.
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(branches_.size()); }

  /// On entry values[b] is the sum of the components of branch b; on return it includes the maxima that are terms of
  /// the branch, so that values[0] is the blob's field.
  void add_up(std::span<double> values) const;

  /// The branches of every selection that may be the greatest. sums[b] is the range of the sum of branch b's
  /// components; {0, 0} stands for a branch without components.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> selections(std::span<const FieldRange> sums) const;

  /// An upper bound of the number of selections where only these branches (is_there[b]) have components of their own.
  [[nodiscard]] std::size_t most_selections(std::vector<bool> is_there) const;

 private:
  using Sets = std::vector<std::vector<std::uint32_t>>;
  [[nodiscard]] Sets selections_of(std::uint32_t branch, std::span<const double> low,
                                   std::span<const double> high) const;

  std::vector<scene::Branch> branches_;
  std::vector<std::vector<std::uint32_t>> maxima_of_;    ///< by branch: the maxima that are terms of its sum
  std::vector<std::vector<std::uint32_t>> branches_of_;  ///< by maximum: its branches
};

}  // namespace isl::render
