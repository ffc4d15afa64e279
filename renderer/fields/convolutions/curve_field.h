// The fields of single convolved curves, without amplitude and strength: at a point, over a box, and at a distance. All
// is in the component's own space; a convolved Circle is called a ring. Their fields along a ray are in
// segment_lanes-inl.h and ring_lanes-inl.h.
#pragma once

#include "base/check.h"
#include "renderer/fields/kernels/kernel_constants.h"
#include "renderer/fields/skeletons/circle.h"
#include "renderer/fields/skeletons/segment.h"

namespace isl::render {

struct CurveSample {
  double value = 0;
  Vec3 gradient{0};
};

/// An enclosure of the values over a box, rounding included; both are 0 exactly when the support does not reach the
/// box.
struct CurveRange {
  double low, high;
};

[[nodiscard]] CurveSample curve_sample(const KernelConstants& kernel, const Segment& segment, const Vec3& p);
[[nodiscard]] CurveSample curve_sample(const KernelConstants& kernel, const Circle& ring, const Vec3& p);
[[nodiscard]] CurveRange curve_range(const KernelConstants& kernel, const Segment& segment, const Box& box);
[[nodiscard]] CurveRange curve_range(const KernelConstants& kernel, const Circle& ring, const Box& box);

/// Upper bound of the value where the squared distance to the curve is at least q squared radii. It falls with q.
[[nodiscard]] double curve_most(const KernelConstants& kernel, const Segment& segment, double q);
[[nodiscard]] double curve_most(const KernelConstants& kernel, const Circle& ring, double q);

/// The greatest value anywhere, to a few digits.
[[nodiscard]] double curve_peak(const KernelConstants& kernel, const Segment& segment);
[[nodiscard]] double curve_peak(const KernelConstants& kernel, const Circle& ring);

/// 1 / (radius of the support).
template <class Curve>
[[nodiscard]] double per_support(const KernelConstants& kernel, const Curve& curve) {
  return std::sqrt(kernel.scale) / curve.radius;
}

// Other skeletons cannot be convolved; these overloads only make generic code compile.
template <class Other>
[[nodiscard]] CurveSample curve_sample(const KernelConstants&, const Other&, const Vec3&) {
  ISL_CHECK(false, "no curve");
}
template <class Other>
[[nodiscard]] CurveRange curve_range(const KernelConstants&, const Other&, const Box&) {
  ISL_CHECK(false, "no curve");
}
template <class Other>
[[nodiscard]] double curve_most(const KernelConstants&, const Other&, double) {
  ISL_CHECK(false, "no curve");
}
template <class Other>
[[nodiscard]] double curve_peak(const KernelConstants&, const Other&) {
  ISL_CHECK(false, "no curve");
}

}  // namespace isl::render
