// Convolved curves one at a time, without amplitude and strength: at a point, over a box, and at a distance. In the
// component's own space, where a Circle is a ring. What a ray sees of them is in
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

/// Lowest and highest value over a box, enclosing their rounding; both 0 exactly when the support does not reach it.
struct CurveRange {
  double low, high;
};

[[nodiscard]] CurveSample curve_sample(const KernelConstants& kernel, const Segment& segment, const Vec3& p);
[[nodiscard]] CurveSample curve_sample(const KernelConstants& kernel, const Circle& ring, const Vec3& p);
[[nodiscard]] CurveRange curve_range(const KernelConstants& kernel, const Segment& segment, const Box& box);
[[nodiscard]] CurveRange curve_range(const KernelConstants& kernel, const Circle& ring, const Box& box);

/// No value is greater where the squared distance to the curve is q radii squared or more; falls with q.
[[nodiscard]] double curve_most(const KernelConstants& kernel, const Segment& segment, double q);
[[nodiscard]] double curve_most(const KernelConstants& kernel, const Circle& ring, double q);

/// The greatest value anywhere, to a few digits.
[[nodiscard]] double curve_peak(const KernelConstants& kernel, const Segment& segment);
[[nodiscard]] double curve_peak(const KernelConstants& kernel, const Circle& ring);

/// One over the support's radius.
template <class Curve>
[[nodiscard]] double per_support(const KernelConstants& kernel, const Curve& curve) {
  return std::sqrt(kernel.scale) / curve.radius;
}

// No other skeleton is convolved.
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
