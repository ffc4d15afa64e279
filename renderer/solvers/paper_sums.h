// What the interpolants on a stretch of a ray add up to, for the published solver, and where that crosses the threshold:
// one cubic, or where the blob has maxima one for each selection of branches (fields/branches.h).
#pragma once

#include "renderer/compiled_scene.h"
#include "renderer/solvers/cubic.h"
#include "renderer/solvers/paper_memory.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace isl::render {

class PaperSums {
 public:
  PaperSums(const CompiledBlob& blob, PaperMemory& memory) : blob_(blob), m_(memory) {}

  /// Sums of what is active on a stretch: one, or where the blob has maxima one for each selection of branches, or of a
  /// skeleton one for each field.
  void add_up(double from, double to) {
    const BranchTree& tree = blob_.components.tree;
    const double threshold = blob_.components.threshold;
    m_.sums.clear();
    if (blob_.components.is_skeleton) {
      for (const PaperMemory::Interpolant& piece : m_.active) {
        const CubicPoint a = piece.at(from), b = piece.at(to);
        m_.sums.push_back({a.value - threshold, a.slope, b.value - threshold, b.slope});
      }
      if (m_.sums.empty()) m_.sums.push_back({-threshold, 0, -threshold, 0});
      return;
    }
    m_.branch_sums.assign(std::max(tree.size(), 1u), {});
    constexpr double kFar = std::numeric_limits<double>::infinity();
    std::vector<FieldRange> ranges(tree.size(), {0, 0});
    for (const PaperMemory::Interpolant& piece : m_.active) {
      const CubicPoint a = piece.at(from), b = piece.at(to);
      m_.branch_sums[piece.branch] += {a.value, a.slope, b.value, b.slope};
      if (tree.size() > 0) ranges[piece.branch] = {-kFar, kFar};
    }
    if (tree.size() == 0) {
      m_.sums.push_back({-threshold, 0, -threshold, 0});
      m_.sums.back() += m_.branch_sums[0];
      return;
    }
    for (const std::vector<std::uint32_t>& selection : tree.selections(ranges)) {
      m_.sums.push_back({-threshold, 0, -threshold, 0});
      for (const std::uint32_t branch : selection) m_.sums.back() += m_.branch_sums[branch];
    }
  }

  /// The first u in [0, 1] where one of the sums comes above the threshold; above 1 if none does. h: the stretch's length.
  [[nodiscard]] double enters_at(double h) const {
    double first = 2;
    for (const HermiteSum& s : m_.sums) {
      first = std::min(first, first_crossing_of_cubic(s.value0, s.value0 + h * s.slope0 / 3, s.value1 - h * s.slope1 / 3,
                                                      s.value1));
    }
    return first;
  }
  /// The first u where the last of them comes below it.
  [[nodiscard]] double leaves_at(double h) const {
    double u = 0;
    for (std::size_t changes = 0; changes <= 3 * m_.sums.size(); ++changes) {
      const auto value_at = [&](const HermiteSum& s) {
        return cubic_at(s.value0, s.value0 + h * s.slope0 / 3, s.value1 - h * s.slope1 / 3, s.value1, u);
      };
      const HermiteSum* followed = m_.sums.data();
      for (const HermiteSum& s : m_.sums) {
        if (value_at(s).value > value_at(*followed).value) followed = &s;
      }
      const CubicPoint start = value_at(*followed);
      if (!(start.value > 0)) return u;
      const double rest = 1 - u, third = rest / 3;
      const double step = first_crossing_of_cubic(-start.value, -(start.value + third * start.slope),
                                                  -(followed->value1 - third * h * followed->slope1), -followed->value1);
      if (step > 1) return 2;
      u += step * rest;
    }
    return u;
  }

 private:
  const CompiledBlob& blob_;
  PaperMemory& m_;
};

}  // namespace isl::render
