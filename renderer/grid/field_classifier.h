// Classifies a box of a blob's space from the ranges of the fields that reach it: certainly outside, certainly inside,
// or in need of a solver. This is the classifier that grid/grid_builder.h uses for blobs.
#pragma once

#include "renderer/fields/component_table.h"
#include "renderer/fields/lipschitz.h"
#include "renderer/grid/blob_grid.h"
#include "renderer/grid/brick_part.h"
#include "renderer/grid/field_cores.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace isl::render {

class FieldClassifier {
 public:
  FieldClassifier(const ComponentTable& table, CellRule rule)
      : table_(table), tree_(table.tree), cores_(table), rule_(rule), classify_(rule != CellRule::none) {
    reach_.resize(table.size());
    fitting_.resize(table.size());
    is_limb_.resize(table.size());
    for (const FieldGroup& group : table.groups) {
      const bool is_limb = group.skeleton != scene::Skeleton::point || group.is_mapped;
      for (std::uint32_t i = group.begin; i < group.end; ++i) {
        const Vec3 size = support_bounds(table, group, i).size();
        reach_[i] = support_radius(table, group, i);
        fitting_[i] = std::max(reach_[i], std::max({size.x, size.y, size.z}) * (1.0 / kMostAlong));
        is_limb_[i] = is_limb;
      }
    }
    worth_a_split_ = kWorthASplit * std::clamp(std::cbrt(static_cast<double>(table.size()) / kManyFields), 1.0, 2.0);
    // If cells are not classified, small cells gain nothing but short lists.
    if (rule == CellRule::ranges && !table.is_unblended)
      limb_cost_ = std::clamp((kWorthASplit + 1) * std::sqrt(kFewFields / static_cast<double>(table.size())), 1.0,
                              kWorthASplit + 1);
  }

  CellKind classify(const Box& box, std::span<const std::uint32_t> items, std::vector<std::uint32_t>& kept) const {
    kept.clear();
    if (table_.is_unblended) return classify_greatest(box, items, kept);
    double low = 0, high = 0, magnitude = 0;
    std::vector<double> lows(tree_.size()), highs(tree_.size());
    for_each_range(box, items, [&](std::uint32_t item, const FieldRange& range) {
      kept.push_back(item);
      double& branch_low = tree_.size() == 0 ? low : lows[table_.branch[item]];
      double& branch_high = tree_.size() == 0 ? high : highs[table_.branch[item]];
      branch_low += range.low;
      branch_high += range.high;
      magnitude += std::max(-range.low, range.high);
    });
    if (kept.empty()) return CellKind::empty;
    if (!classify_) return CellKind::leaf;
    if (tree_.size() > 0) {
      tree_.add_up(lows);
      tree_.add_up(highs);
      low = lows[0];
      high = highs[0];
    }
    const double slack = magnitude * (kRangeSlack + 0x1p-52 * static_cast<double>(kept.size()));
    if (high < table_.threshold - slack) return CellKind::empty;
    if (low > table_.threshold + slack) return CellKind::inside;
    return CellKind::leaf;
  }

  /// The part of a leaf outside which the field is below the threshold. (The octree that culls by Lipschitz constants
  /// knows no better than its cells.)
  [[nodiscard]] Box core(const Box& box, std::span<const std::uint32_t> kept) const {
    return rule_ == CellRule::ranges ? cores_.core(box, kept) : box;
  }

  /// One list for each selection of branches that may be the greatest; for an unblended blob, one for each component.
  void list(const Box& box, std::span<const std::uint32_t> kept, ListSink& lists) const {
    if (table_.is_unblended) {
      for (const std::uint32_t item : kept) lists.add({&item, 1});
      return;
    }
    if (tree_.size() == 0) return lists.add(kept);
    std::vector<FieldRange> sums(tree_.size(), {0, 0});
    constexpr double kFar = std::numeric_limits<double>::infinity();
    for_each_range(box, kept, [&](std::uint32_t item, const FieldRange& range) {
      FieldRange& sum = sums[table_.branch[item]];
      sum = classify_ ? FieldRange{sum.low + range.low, sum.high + range.high} : FieldRange{-kFar, kFar};
    });
    std::vector<std::uint32_t> chosen;
    for (const std::vector<std::uint32_t>& selection : tree_.selections(sums)) {
      chosen.clear();
      for (const std::uint32_t item : kept) {
        if (std::ranges::find(selection, table_.branch[item]) != selection.end()) chosen.push_back(item);
      }
      if (!chosen.empty()) lists.add(chosen);
    }
  }

  [[nodiscard]] Box item_bounds(std::uint32_t item) const {
    return support_bounds(table_, table_.group_of(item), item);
  }

  /// The cost of a leaf with this list to a ray, in points.
  [[nodiscard]] double cost(std::span<const std::uint32_t> kept) const {
    double cost = 0;
    for (const std::uint32_t item : kept) cost += is_limb_[item] ? limb_cost_ : 1;
    return cost;
  }

  /// Upper bound of the list entries that a leaf needs which keeps these items; a list itself counts as two.
  [[nodiscard]] std::size_t most_entries(std::span<const std::uint32_t> kept) const {
    if (table_.is_unblended) return 3 * kept.size();
    if (tree_.size() == 0) return kept.size();
    std::vector<bool> is_there(tree_.size(), false);
    for (const std::uint32_t item : kept) is_there[table_.branch[item]] = true;
    return tree_.most_selections(std::move(is_there)) * (kept.size() + 2);
  }

  /// Dividing pays while the fields of a cell cost a ray more than the steps that smaller cells add. A cell with a long
  /// list is divided down to half the smallest support that reaches it, any other down to the size that fits one of its
  /// fields. (An octree that culls by Lipschitz constants is divided by size alone.)
  [[nodiscard]] Division division(double size, const std::vector<std::uint32_t>& kept) const {
    double least = reach_[kept.front()], fitting = fitting_[kept.front()], cost = 0;
    for (const std::uint32_t item : kept) {
      least = std::min(least, reach_[item]);
      fitting = std::min(fitting, fitting_[item]);
      cost += is_limb_[item] ? limb_cost_ : 1;
    }
    if (rule_ == CellRule::lipschitz) return size > 0.5 * fitting ? Division::size : Division::none;
    if (static_cast<double>(kept.size()) > worth_a_split_) return size > 0.5 * least ? Division::lists : Division::none;
    return cost > worth_a_split_ && size > fitting ? Division::size : Division::none;
  }

 private:
  /// Classifies a box of an unblended blob; keeps the components that may have a surface in it or that fill it.
  CellKind classify_greatest(const Box& box, std::span<const std::uint32_t> items,
                             std::vector<std::uint32_t>& kept) const {
    bool is_inside = false;
    for_each_range(box, items, [&](std::uint32_t item, const FieldRange& range) {
      const double slack = kRangeSlack * range.high;
      if (classify_ && range.high < table_.threshold - slack) return;
      kept.push_back(item);
      is_inside = is_inside || range.low > table_.threshold + slack;
    });
    if (kept.empty()) return CellKind::empty;
    return is_inside && classify_ ? CellKind::inside : CellKind::leaf;
  }

  /// Each range is exact except for rounding, which is a few units in the last place of the component's own value even
  /// where the exponential magnifies its argument (hardness ≤ 500: 2⁹ units). A sum adds one unit for each component.
  static constexpr double kRangeSlack = 0x1p-42;

  /// Calls use(item, range) for each item whose support reaches the box. Items ascend.
  template <class Use>
  void for_each_range(const Box& box, std::span<const std::uint32_t> items, const Use& use) const {
    auto group = table_.groups.begin();
    for (const std::uint32_t item : items) {
      while (item >= group->end) ++group;
      const FieldRange range = rule_ == CellRule::lipschitz ? lipschitz_range(table_, *group, item, box)
                                                            : field_range(table_, *group, item, box);
      if (range.low != 0 || range.high != 0) use(item, range);
    }
  }

  // Points are set up and evaluated eight at a time. Measured on the 7,381 flake, quartic and Gaussian, the time is
  // flat from 6 to 16, with the quartic gaining towards 12.
  static constexpr double kWorthASplit = 12;
  // Above this number of fields the grid is larger than the processor's caches, and each further cell costs a ray time
  // to fetch. Lists of 24 instead of 12 take 0.95 of the time with 66,430 fields and 0.92 with 597,871, but 1.02
  // to 1.03 with 820 and 7,381.
  static constexpr double kManyFields = 8192;
  // Limbs and mapped points are set up one by one, and their bounds over long stretches are wide. Cells down to their
  // size, with one field in each, take the coral 0.6, the urchin 0.7 and the crab 0.4 of the time that lists of 12
  // take. Such cells need 5 to 40 kB a limb; therefore, above this number of fields, the cost of a limb falls with the
  // root of the number, to 1 at 169,000.
  static constexpr double kFewFields = 1000;
  // A thread may be a million times as long as thick, so a single limb gets at most this many cells along it.
  static constexpr double kMostAlong = 16;

  const ComponentTable& table_;
  const BranchTree& tree_;
  FieldCores cores_;
  CellRule rule_;
  bool classify_;
  std::vector<double> reach_;
  std::vector<double> fitting_;          ///< the cell size that fits a component: its reach, or a share of its length
  std::vector<bool> is_limb_;            ///< true for anything but a point in the blob's own space
  double worth_a_split_ = kWorthASplit;  ///< the cost above which a cell is divided
  double limb_cost_ = 1;                 ///< the cost of a limb, in points
};

}  // namespace isl::render
