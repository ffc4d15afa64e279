// The part of a box in which a blob's field can reach the threshold T, as a box, for cells whose fields are points.
//
// Let Mᵢ be the greatest value of field i in the box, from above, and M the sum of those that are positive. Where the
// sum reaches T,
// - some field i has at least its share T Mᵢ/M of it. So the part lies within a union of balls. The same holds for the
//   sum of any selection of the fields, so that it does not matter by which branches a blob is combined.
// - in a single sum, every field i has at least what the others leave: T − (M − Mᵢ). So the part lies within each ball
//   for which that is positive.
#pragma once

#include "renderer/fields/component_table.h"
#include "renderer/fields/kernels/kernel_levels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace isl::render {

class FieldCores {
 public:
  explicit FieldCores(const ComponentTable& table) : table_(table) {
    for (const FieldGroup& group : table.groups) {
      if (group.begin == table.plain_points || group.kernel.is_convolved) break;
      levels_.emplace_back(group.kernel);
      end_ = group.end;
    }
  }

  /// The core of a box that these items reach, in ascending order; empty if the field is below the threshold
  /// throughout.
  [[nodiscard]] Box core(const Box& box, std::span<const std::uint32_t> items) const {
    if (items.size() > kMostItems || items.back() >= end_) return box;
    std::array<double, kMostItems> greatest;  // the Mᵢ
    double sum = 0;
    for_each_with_levels(items, [&](std::size_t i, const KernelLevels& levels) {
      const double distance2 = total(least_distances2(items[i], box));
      greatest[i] = table_.amplitude[items[i]] * levels.most_at(table_.scale[items[i]] * distance2);
      sum += std::max(greatest[i], 0.0);
    });
    const double needed = table_.threshold - kSlack * sum;
    if (!(needed > 0 && sum <= std::numeric_limits<double>::max())) return box;
    const bool is_one_sum = !table_.is_unblended && table_.tree.size() == 0;
    Box some, all = box;
    for_each_with_levels(items, [&](std::size_t i, const KernelLevels& levels) {
      if (!(greatest[i] > 0)) return;
      // An unblended blob is the greatest of its fields.
      const double share = table_.is_unblended ? needed : needed / sum * greatest[i];
      const double left = needed - (sum - greatest[i]);
      if (!contains(some, box)) some.extendBy(part_with(share, items[i], levels, box));
      if (is_one_sum && left > 0) all = common(all, part_with(left, items[i], levels, box));
    });
    return common(all, some);
  }

 private:
  // Longer lists are those of cells where large items overlap, which are inside nearly everywhere.
  static constexpr std::size_t kMostItems = 64;
  /// The core goes by a threshold that is lower by this share of M: far more than rounding does to F.
  static constexpr double kSlack = 0x1p-20;

  /// Calls use(i, levels of the kernel of items[i]) for each item.
  template <class Use>
  void for_each_with_levels(std::span<const std::uint32_t> items, const Use& use) const {
    std::size_t group = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
      while (items[i] >= table_.groups[group].end) ++group;
      use(i, levels_[group]);
    }
  }

  /// The squares of the item's distances from the box along the axes.
  [[nodiscard]] std::array<double, 3> least_distances2(std::uint32_t item, const Box& box) const {
    const Vec3 centre(table_.x[item], table_.y[item], table_.z[item]);
    std::array<double, 3> squares;
    for (int axis = 0; axis < 3; ++axis) {
      const double beside = std::max({0.0, box.min[axis] - centre[axis], centre[axis] - box.max[axis]});
      squares[static_cast<std::size_t>(axis)] = beside * beside;
    }
    return squares;
  }
  [[nodiscard]] static double total(const std::array<double, 3>& squares) {
    return squares[0] + squares[1] + squares[2];
  }

  /// The box around the part of `box` in which the item's field is at least `value`.
  [[nodiscard]] Box part_with(double value, std::uint32_t item, const KernelLevels& levels, const Box& box) const {
    const double v = levels.farthest_with(value / table_.amplitude[item]);
    const double radius2 = v / table_.scale[item];
    const std::array<double, 3> beside2 = least_distances2(item, box);
    if (total(beside2) > radius2) return {};
    const Vec3 centre(table_.x[item], table_.y[item], table_.z[item]);
    Box part = box;
    for (int axis = 0; axis < 3; ++axis) {
      const auto other = static_cast<std::size_t>(axis + 1) % 3, third = static_cast<std::size_t>(axis + 2) % 3;
      const double half = std::sqrt(radius2 - beside2[other] - beside2[third]);
      part.min[axis] = std::max(part.min[axis], centre[axis] - half);
      part.max[axis] = std::min(part.max[axis], centre[axis] + half);
    }
    return part;
  }

  [[nodiscard]] static bool contains(const Box& outer, const Box& inner) {
    bool contains = true;
    for (int axis = 0; axis < 3; ++axis)
      contains &= outer.min[axis] <= inner.min[axis] && outer.max[axis] >= inner.max[axis];
    return contains;
  }
  [[nodiscard]] static Box common(const Box& a, const Box& b) {
    Box part;
    for (int axis = 0; axis < 3; ++axis) {
      part.min[axis] = std::max(a.min[axis], b.min[axis]);
      part.max[axis] = std::min(a.max[axis], b.max[axis]);
    }
    return part;
  }

  const ComponentTable& table_;
  std::vector<KernelLevels> levels_;  ///< of each group of points that are not mapped; these groups come first
  std::uint32_t end_ = 0;             ///< behind the last of these points
};

}  // namespace isl::render
