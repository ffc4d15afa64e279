// Tables that the published solver makes from a blob's fields before any ray: upper bounds of their kernels for its
// fast rejection and, for `iso`, where each field alone reaches the threshold.
//
// A bound is interpolated linearly from the kernel's profile at equal steps of v. Every kernel is convex in v, so its
// chord lies above it, and no kernel is evaluated for the bound.
#pragma once

#include "renderer/fields/component_table.h"

#include <algorithm>
#include <array>
#include <vector>

namespace isl::render {

/// The argument v at which a field alone reaches the threshold, and the field's slope in v there. v = 0 if it does not
/// reach it.
struct IsoLevel {
  double v = 0, slope = 0;
};

struct PaperTables {
  /// With 64 steps the hardest Gaussian falls by the factor e^(15/64) in a step, and its chord is at most 0.7 % above
  /// it.
  static constexpr int kSteps = 64;

  std::vector<std::array<double, kSteps + 1>> profiles;  ///< φ by group
  std::vector<IsoLevel> iso;                             ///< by component; unset for convolved fields, half-spaces and
                                                         ///< sheets

  /// Upper bound of φ for the fields of a group whose argument is at least v.
  [[nodiscard]] double profile_bound(const ComponentTable& table, const FieldGroup& group, double v) const {
    const double place = v / group.kernel.support * kSteps;
    if (!(place < kSteps)) return 0;
    const auto& profile = profiles[static_cast<std::size_t>(&group - table.groups.data())];
    const auto step = static_cast<std::size_t>(place);
    return std::lerp(profile[step], profile[step + 1], place - static_cast<double>(step));
  }
};

/// `iso`: also makes the levels of the components.
[[nodiscard]] PaperTables make_paper_tables(const ComponentTable& table, bool iso);

}  // namespace isl::render
