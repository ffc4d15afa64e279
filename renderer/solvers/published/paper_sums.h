// The sums of the interpolants on a stretch of a ray, for the published solver, and where they cross the threshold.
// There is one cubic or, if the blob has maxima, one for each selection of branches (fields/branches.h).
#pragma once

#include "renderer/compiled/compiled_scene.h"
#include "renderer/numerics/cubic.h"
#include "renderer/solvers/published/paper_memory.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace isl::render {

class PaperSums {
 public:
  PaperSums(const CompiledBlob& blob, PaperMemory& memory) : blob_(blob), m_(memory) {}

  /// Computes the sums of the active fields on a stretch: one sum; if the blob has maxima, one for each selection of
  /// branches; if it is unblended, one for each field.
  void add_up(double from, double to) {
    const BranchTree& tree = blob_.components.tree;
    const double threshold = blob_.components.threshold;
    m_.sums.clear();
    if (blob_.components.is_unblended) {
      for (const std::uint32_t index : m_.active) {
        m_.sums.push_back({-threshold, 0, -threshold, 0});
        m_.sums.back() += m_.piece_on(m_.fields[index], from, to);
      }
      if (m_.sums.empty()) m_.sums.push_back({-threshold, 0, -threshold, 0});
      return;
    }
    m_.branch_sums.assign(std::max(tree.size(), 1u), {});
    constexpr double kFar = std::numeric_limits<double>::infinity();
    std::vector<FieldRange> ranges(tree.size(), {0, 0});
    for (const std::uint32_t index : m_.active) {
      const PaperMemory::Field& field = m_.fields[index];
      m_.branch_sums[field.branch] += m_.piece_on(field, from, to);
      if (tree.size() > 0) ranges[field.branch] = {-kFar, kFar};
    }
    if (tree.size() == 0) {
      m_.sums.push_back({-threshold, 0, -threshold, 0});
      m_.sums.back() += m_.branch_sums[0];
      return;
    }
    m_.selections = tree.selections(ranges);
    for (const std::vector<std::uint32_t>& selection : m_.selections) {
      m_.sums.push_back({-threshold, 0, -threshold, 0});
      for (const std::uint32_t branch : selection) m_.sums.back() += m_.branch_sums[branch];
    }
  }

  /// A crossing at u in [0, 1] on a stretch, with u above 1 for none, and the sum that makes the surface there.
  struct Crossing {
    double u = 2;
    std::size_t sum = 0;
  };
  /// The first place where one of the sums comes above the threshold. h: the stretch's length. `exclude`: sums whose
  /// control points are all below the threshold are not solved.
  [[nodiscard]] Crossing enters_at(double h, bool exclude) const {
    Crossing first;
    for (std::size_t i = 0; i < m_.sums.size(); ++i) {
      const HermiteSum& s = m_.sums[i];
      const double b1 = s.value0 + h * s.slope0 / 3, b2 = s.value1 - h * s.slope1 / 3;
      if (exclude && std::max({s.value0, b1, b2, s.value1}) < 0) continue;
      const double u = first_crossing_of_cubic(s.value0, b1, b2, s.value1);
      if (u < first.u) first = {u, i};
    }
    return first;
  }
  /// The first place where the last of the sums comes below the threshold. `exclude`: nothing is solved if the control
  /// points of one sum are all above it.
  [[nodiscard]] Crossing leaves_at(double h, bool exclude) const {
    const auto is_above = [&](const HermiteSum& s) {
      return std::min({s.value0, s.value0 + h * s.slope0 / 3, s.value1 - h * s.slope1 / 3, s.value1}) > 0;
    };
    if (exclude && std::any_of(m_.sums.begin(), m_.sums.end(), is_above)) return {};
    double u = 0;
    std::size_t followed = 0;
    for (std::size_t changes = 0; changes <= 3 * m_.sums.size(); ++changes) {
      followed = 0;
      const auto value_at = [&](const HermiteSum& s) {
        return cubic_at(s.value0, s.value0 + h * s.slope0 / 3, s.value1 - h * s.slope1 / 3, s.value1, u);
      };
      for (std::size_t i = 0; i < m_.sums.size(); ++i) {
        if (value_at(m_.sums[i]).value > value_at(m_.sums[followed]).value) followed = i;
      }
      const HermiteSum& sum = m_.sums[followed];
      const CubicPoint start = value_at(sum);
      if (!(start.value > 0)) break;
      const double rest = 1 - u, third = rest / 3;
      const double step = first_crossing_of_cubic(-start.value, -(start.value + third * start.slope),
                                                  -(sum.value1 - third * h * sum.slope1), -sum.value1);
      if (step > 1) return {};
      u += step * rest;
    }
    return {u, followed};
  }

  /// The place where a ray that starts on the surface comes back to it; until then it is on `side` (+1 outside). The
  /// known root is divided out (hermite-inl.h). The whole cubic is shifted so that it is zero at the start: on a
  /// stretch as short as the rounding of the start, that shift is as large as the change of the cubic. If the blob has
  /// maxima, another sum may be the greatest by then, and no place is returned.
  [[nodiscard]] Crossing comes_back_at(double h, double side) const {
    const HermiteSum& s = m_.sums.front();
    const double c2 = side * (s.value1 - s.value0), c1 = 1.5 * (c2 - side * h * s.slope1 / 3), c0 = side * h * s.slope0;
    if (m_.sums.size() > 1 || !(c0 < 0)) return {};
    return {first_crossing_of_cubic(c0, (c0 + 2 * c1) / 3, (2 * c1 + c2) / 3, c2), 0};
  }

  /// True if a field is part of a sum.
  [[nodiscard]] bool has(std::size_t sum, std::size_t active) const {
    if (blob_.components.is_unblended) return sum == active;
    if (blob_.components.tree.size() == 0) return true;
    const std::vector<std::uint32_t>& selection = m_.selections[sum];
    return std::find(selection.begin(), selection.end(), m_.fields[m_.active[active]].branch) != selection.end();
  }

 private:
  const CompiledBlob& blob_;
  PaperMemory& m_;
};

}  // namespace isl::render
