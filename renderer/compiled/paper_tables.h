// What the published solver knows of a blob's fields before any ray: how high their kernels are, for its fast
// rejection, and where each alone is at its own surface, for `iso`.
//
// A peak is read off the kernel's profile at equal steps of v, between which it lies below the chord: every kernel is
// convex in v. So no kernel is evaluated for it.
#pragma once

#include "renderer/fields/component_table.h"

#include <algorithm>
#include <array>
#include <vector>

namespace isl::render {

/// Where a field alone reaches the threshold: v and the field's slope in v. v = 0 for one that does not.
struct IsoLevel {
  double v = 0, slope = 0;
};

struct PaperTables {
  /// At 64 steps the hardest Gaussian's chord, over a factor e^(15/64), is 0.7 % above it.
  static constexpr int kSteps = 64;

  std::vector<std::array<double, kSteps + 1>> profiles;  ///< φ by group
  std::vector<IsoLevel> iso;                             ///< by component; of convolved ones and half-spaces none

  /// φ of a group of fields is at most this where the argument is at least v.
  [[nodiscard]] double profile_bound(const ComponentTable& table, const FieldGroup& group, double v) const {
    const double place = v / group.kernel.support * kSteps;
    if (!(place < kSteps)) return 0;
    const auto& profile = profiles[static_cast<std::size_t>(&group - table.groups.data())];
    const auto step = static_cast<std::size_t>(place);
    return std::lerp(profile[step], profile[step + 1], place - static_cast<double>(step));
  }
};

/// `iso`: with the levels of components.
[[nodiscard]] PaperTables make_paper_tables(const ComponentTable& table, bool iso);

}  // namespace isl::render
