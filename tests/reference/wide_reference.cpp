#include "tests/reference/wide_reference.h"

#include "renderer/reference/reference_tracer.h"
#include "renderer/reference/reference_window.h"

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

ValueAndSlope wide_error(const scene::Database& database, const LineOfSight& line, long double t,
                         const ValueAndSlope& found) {
  const wide_reference::ReferenceField field(database, database.blobs.front());
  const wide_reference::Jet known = wide_reference::FieldOnRay(field, {wide_reference::interval_of(line.origin),
                                                                       wide_reference::interval_of(line.direction)})
                                        .at(t);
  return {(known.value - Interval(found.value)).magnitude(), (known.slope - Interval(found.slope)).magnitude()};
}

double wide_kernel_error(const scene::Kernel& kernel) {
  const wide_reference::ReferenceKernel profile(kernel);
  const Interval one(1);
  const wide_reference::Jet phi = profile.over(one);
  const Interval value = phi.value - one, slope = phi.slope / Interval(kernel.hardness) + one;
  if (!value.contains(0) || !slope.contains(0)) return std::numeric_limits<double>::infinity();
  return static_cast<double>(std::max(value.magnitude(), slope.magnitude()));
}

double wide_line_error(const scene::Kernel& kernel, double y) {
  using wide_reference::Real;
  const wide_reference::ReferenceWindow window(kernel);
  const Real end2 = 1 - Real(y), end = sqrtf128(end2);
  Real known = 0;
  if (kernel.shape == scene::KernelShape::quartic) {
    known = Real(16) / 15 * end2 * end2 * end;
  } else {
    // At the border Y = B = ε + 1, where −g′ is 6(1 − y)/B⁴ to first order. The integral is that of 1/Y², with
    // Y = P + v², and of its tangent.
    const Real b = 1 / sqrtf128(sqrtf128(window.at(1, 1).fall / 6)), p = b - 1 + Real(y);
    known = end / (p * b) + atanf128(end / sqrtf128(p)) / (p * sqrtf128(p)) - 2 * end / (b * b) +
            4 / (b * b * b) * ((p - b) * end + end2 * end / 3);
  }
  return static_cast<double>(fabsf128(window.line(y).value / known - 1));
}

}  // namespace isl::reference
