// The interface of windows to curve_remainder-inl.h: bounds of the derivatives, along a ray, of the field g(|p − s|²)
// of a single point s of a curve, while p is within the support of s.
#if defined(ISL_RENDERER_FIELDS_CONVOLUTIONS_WINDOW_BOUNDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_CONVOLUTIONS_WINDOW_BOUNDS_INL_H_
#undef ISL_RENDERER_FIELDS_CONVOLUTIONS_WINDOW_BOUNDS_INL_H_
#else
#define ISL_RENDERER_FIELDS_CONVOLUTIONS_WINDOW_BOUNDS_INL_H_
#endif

#include "renderer/simd/octet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// second_low ≤ g″ ≤ second_high with second_low ≤ 0 ≤ second_high, |g‴| ≤ third, |g⁗| ≤ fourth, for all points with
/// y ≥ y_least and ((p − s)·D)² ≤ e², |D|² = speed2.
struct WindowBounds {
  Octet second_low, second_high, third, fourth;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
