// The interface of convolved skeletons to the inner loops: a struct of octets as in skeletons/ray_form-inl.h, with
// lengths in support radii. Its along() and shape() take 1/(radius of the support); at() returns a CurvePoint; most()
// and stretch() return the bounds.
#if defined(ISL_RENDERER_FIELDS_CONVOLUTIONS_CURVE_POINT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_CONVOLUTIONS_CURVE_POINT_INL_H_
#undef ISL_RENDERER_FIELDS_CONVOLUTIONS_CURVE_POINT_INL_H_
#else
#define ISL_RENDERER_FIELDS_CONVOLUTIONS_CURVE_POINT_INL_H_
#endif

#include "renderer/simd/octet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// f and df/dt; value_terms and slope_terms are the scales of their rounding errors, and `moved` is how much f changes
/// if positions are off by `size`.
struct CurvePoint {
  Octet value, slope, value_terms, slope_terms, moved;
};

/// The lanes of a skeleton that can be convolved; void for any other.
template <class Shape>
struct CurveFormOf {
  using type = void;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
