// The interface of kernels for the code that evaluates a field and bounds it along a ray. A kernel is a class with
//
//   static constants(hardness), and a constructor from them
//   support(), value(v), value_and_slope(v), curvature(v) = φ″
//   slopes(v_least), on_quadratic(v₀, κ, u_near, u_far)
//   most(v)                    an upper bound of value(v), if one takes less time
//   is_smooth(v_low, v_high)   true if the bounds of f⁗ hold for all v between; false if φ″ jumps there
//
// and a row in renderer/scene/kernel_shapes.def.
#if defined(ISL_RENDERER_FIELDS_KERNELS_KERNEL_BOUNDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_KERNELS_KERNEL_BOUNDS_INL_H_
#undef ISL_RENDERER_FIELDS_KERNELS_KERNEL_BOUNDS_INL_H_
#else
#define ISL_RENDERER_FIELDS_KERNELS_KERNEL_BOUNDS_INL_H_
#endif

#include "renderer/fields/kernels/kernel_constants.h"
#include "renderer/simd/octet-inl.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// φ(v) and dφ/dv.
struct KernelValue {
  Octet value, slope;
};

/// An upper bound of φ(v) for v within the support: that of the kernel, if it has one that takes less time.
template <class Kernel>
[[nodiscard]] HWY_INLINE Octet most_of(const Kernel& kernel, const Octet& v) {
  if constexpr (requires { kernel.most(v); }) {
    return kernel.most(v);
  } else {
    return kernel.value(v);
  }
}

/// Enclosure [low, high] of f″ and a bound of |f⁗| over an interval of a ray, f = φ(v(t)).
struct SecondAndFourth {
  Octet low, high, fourth;
};

/// max |φ′|, |φ″|, |φ‴|, |φ⁗| over v ≥ some least value. All kernels fall (φ′ ≤ 0) and are convex (φ″ ≥ 0).
struct SlopeBounds {
  Octet first, second, third, fourth;
};

/// Bounds of v along an interval of a ray: |v′| ≤ first, second_low ≤ v″ ≤ second_high, |v‴| ≤ third, |v⁗| ≤ fourth.
struct JetBounds {
  Octet least;  ///< lower bound of v
  Octet first, second_low, second_high, third, fourth;
};

/// The chain rule (Faà di Bruno) on bounds: f″ = φ″v′² + φ′v″ and f⁗ = φ⁗v′⁴ + 6φ‴v′²v″ + φ″(3v″² + 4v′v‴) + φ′v⁗.
template <class Kernel>
HWY_INLINE SecondAndFourth compose(const Kernel& kernel, const JetBounds& v) {
  const SlopeBounds phi = kernel.slopes(v.least);
  const Octet zero(0.0);
  const Octet first2 = v.first * v.first;
  const Octet second = max(abs(v.second_low), abs(v.second_high));
  return {zero - phi.first * max(v.second_high, zero), phi.second * first2 + phi.first * max(zero - v.second_low, zero),
          phi.fourth * first2 * first2 + Octet(6.0) * phi.third * first2 * second +
              phi.second * (Octet(3.0) * second * second + Octet(4.0) * v.first * v.third) + phi.first * v.fourth};
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
