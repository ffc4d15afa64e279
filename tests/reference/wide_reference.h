// The wide reference (renderer/reference/real.h) for tests that include the one in long double: no file can include
// both.
#pragma once

#include "renderer/scene/database.h"
#include "tests/reference/random_scenes.h"

#include <cstddef>
#include <vector>

namespace isl::reference {

/// A place where F changes sign, rounded to long double, within t ± slack.
struct WideCrossing {
  long double t, slack;
};

struct WideRoots {
  bool starts_inside;
  std::vector<WideCrossing> crossings;  ///< ascending
  std::size_t touches;
};

/// All roots of the database's first blob along a line in the blob's space.
[[nodiscard]] WideRoots wide_roots(const scene::Database& database, const LineOfSight& line);

/// F of the database's first blob at a place of a line, and its slope along the line.
struct ValueAndSlope {
  long double value, slope;
};

/// How far these are from the true ones.
[[nodiscard]] ValueAndSlope wide_error(const scene::Database& database, const LineOfSight& line, long double t,
                                       const ValueAndSlope& found);

/// The greatest of |φ(1) − 1| and |φ′(1)/h + 1| that the kernel's enclosures allow; infinite if they exclude that both
/// are zero. Precondition: the radius means the surface.
[[nodiscard]] double wide_kernel_error(const scene::Kernel& kernel);

/// The relative error of a convolved infinite line, at the share y of the squared support, against its closed form.
/// Precondition: mode convolution, 0 < y < 1.
[[nodiscard]] double wide_line_error(const scene::Kernel& kernel, double y);

}  // namespace isl::reference
