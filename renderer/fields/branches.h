// The tree of sums and maxima that a blob is (scene::Branch), worked out from what its branches' own components add up to.
//
// Of a maximum of sums only one branch counts at a point, and a sum is smooth where a maximum has edges. So wherever
// several can be the greatest, the blob is the greatest of its *selections*: for each maximum one branch, or none where
// a branch without any component near (its field is zero) can be the greatest.
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

  /// 0 where the blob is one sum.
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(branches_.size()); }

  /// values[b]: what the components of branch b add up to; becomes that with its maxima. values[0] is then the blob's.
  void add_up(std::span<double> values) const;

  /// The branches of every selection that may be the greatest, given what the components of each branch can add up to.
  /// {0, 0} stands for a branch without components.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> selections(std::span<const FieldRange> sums) const;

 private:
  using Sets = std::vector<std::vector<std::uint32_t>>;
  [[nodiscard]] Sets selections_of(std::uint32_t branch, std::span<const double> low, std::span<const double> high) const;

  std::vector<scene::Branch> branches_;
  std::vector<std::vector<std::uint32_t>> maxima_of_;     ///< by branch: the maxima that its sum has
  std::vector<std::vector<std::uint32_t>> branches_of_;  ///< by maximum
};

}  // namespace isl::render
