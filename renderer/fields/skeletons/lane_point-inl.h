// What lanes that are no quadratics give at one t.
#if defined(ISL_RENDERER_FIELDS_SKELETONS_LANE_POINT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_SKELETONS_LANE_POINT_INL_H_
#undef ISL_RENDERER_FIELDS_SKELETONS_LANE_POINT_INL_H_
#else
#define ISL_RENDERER_FIELDS_SKELETONS_LANE_POINT_INL_H_
#endif

#include "renderer/simd/octet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// v = scale · q and dv/dt.
struct LanePoint {
  Octet v, slope;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
