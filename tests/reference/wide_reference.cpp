#include "tests/reference/wide_reference.h"

#include "renderer/reference/reference_tracer.h"

#include <algorithm>
#include <limits>

namespace isl::reference {

using wide_reference::Interval;

WideRoots wide_roots(const scene::Database& database, const LineOfSight& line) {
  const wide_reference::RayRoots roots = wide_reference::roots_along(
      wide_reference::ReferenceField(database, database.blobs.front()),
      {wide_reference::interval_of(line.origin), wide_reference::interval_of(line.direction)}, {});
  WideRoots rounded{roots.starts_inside, {}, roots.touches.size()};
  for (const wide_reference::Crossing& crossing : roots.crossings) {
    rounded.crossings.push_back({static_cast<long double>(crossing.t), static_cast<long double>(crossing.slack)});
  }
  return rounded;
}

double wide_kernel_error(const scene::Kernel& kernel) {
  const wide_reference::ReferenceKernel profile(kernel);
  const Interval one(1);
  const Interval value = profile.value(one) - one;
  const Interval slope = profile.slope(one) / Interval(kernel.hardness) + one;
  if (!value.contains(0) || !slope.contains(0)) return std::numeric_limits<double>::infinity();
  return static_cast<double>(std::max(value.magnitude(), slope.magnitude()));
}

}  // namespace isl::reference
