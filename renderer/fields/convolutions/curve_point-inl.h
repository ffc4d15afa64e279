// What eight convolved curves give at one t.
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

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
