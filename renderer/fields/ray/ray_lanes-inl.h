// The fields of one cell along one ray, eight fields side by side.
#if defined(ISL_RENDERER_FIELDS_RAY_RAY_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_RAY_RAY_LANES_INL_H_
#undef ISL_RENDERER_FIELDS_RAY_RAY_LANES_INL_H_
#else
#define ISL_RENDERER_FIELDS_RAY_RAY_LANES_INL_H_
#endif

#include "renderer/fields/ray/field_lanes-inl.h"
#include "renderer/fields/ray/lane_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

using RayLanes = FieldLanes<LaneSetup>;
using FieldAt = RayLanes::FieldAt;
using Remainder = RayLanes::Remainder;

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
