// The fields of one cell along eight rays, one ray in each lane. Neighbouring rays meet the same cells; then each field
// is read once for all of them, and all lanes are used, however short the list is.
#if defined(ISL_RENDERER_FIELDS_PACKET_PACKET_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_PACKET_PACKET_LANES_INL_H_
#undef ISL_RENDERER_FIELDS_PACKET_PACKET_LANES_INL_H_
#else
#define ISL_RENDERER_FIELDS_PACKET_PACKET_LANES_INL_H_
#endif

#include "renderer/fields/packet/packet_setup-inl.h"
#include "renderer/fields/ray/field_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

using PacketLanes = FieldLanes<PacketSetup>;

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
