// What a skeleton that is convolved says of itself to the inner loops: as in skeletons/ray_form-inl.h, its lanes in
// support radii. Their along() and shape() are told one over that radius, at() gives a CurvePoint, most() and stretch()
// the bounds.
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

/// f and df/dt; value_terms and slope_terms are what the rounding of each is relative to.
struct CurvePoint {
  Octet value, slope, value_terms, slope_terms;
};

/// The lanes of a skeleton that can be convolved along itself; void where it cannot.
template <class Shape>
struct CurveFormOf {
  using type = void;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
