// Octets read back from LaneMemory: the forms that skeletons take along a ray.
//
// Quadratic lanes: v = v₀ + κ(t − t₀)² on [begin, end), for points and for the pieces of segments, boxes and triangles.
// Cone lanes: the round cone of skeletons/cone.h in (x, ρ²), x = x₀ + x′t and ρ² = n₀ + n₂(t − tₙ)². Circle lanes:
// that of skeletons/circle.h in (z, ρ²), likewise. Segment and ring lanes: convolutions/segment_lanes-inl.h and
// ring_lanes-inl.h, in support radii.
#if defined(ISL_RENDERER_FIELDS_RAY_LANE_COLUMNS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_RAY_LANE_COLUMNS_INL_H_
#undef ISL_RENDERER_FIELDS_RAY_LANE_COLUMNS_INL_H_
#else
#define ISL_RENDERER_FIELDS_RAY_LANE_COLUMNS_INL_H_
#endif

#include "renderer/fields/convolutions/windows-inl.h"
#include "renderer/fields/ray/lane_memory.h"
#include "renderer/fields/skeletons/circle_lanes-inl.h"
#include "renderer/fields/skeletons/cone_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct QuadraticLanes {
  Octet v0, kappa, middle, amplitude;
};

[[nodiscard]] HWY_INLINE QuadraticLanes load_quadratic(const LaneMemory& memory, std::uint32_t i) {
  const double* const at = memory.quadratic.row(i);
  const std::size_t stride = memory.quadratic.stride();
  return {load(at + LaneMemory::kV0 * stride), load(at + LaneMemory::kKappa * stride),
          load(at + LaneMemory::kMiddle * stride), load(at + LaneMemory::kAmplitude * stride)};
}

/// begin or end of the pieces.
[[nodiscard]] HWY_INLINE Octet load_border(const LaneMemory& memory, std::uint32_t i,
                                           LaneMemory::QuadraticColumn column) {
  return load(memory.quadratic.row(i) + static_cast<std::size_t>(column) * memory.quadratic.stride());
}

[[nodiscard]] HWY_INLINE ConeLanes load_cone(const LaneMemory& memory, std::uint32_t i) {
  const double* const at = memory.cone.row(i);
  const std::size_t stride = memory.cone.stride();
  return {load(at + LaneMemory::kX0 * stride),           load(at + LaneMemory::kDx * stride),
          load(at + LaneMemory::kN0 * stride),           load(at + LaneMemory::kN2 * stride),
          load(at + LaneMemory::kNMiddle * stride),      load(at + LaneMemory::kRadius * stride),
          load(at + LaneMemory::kSlope * stride),        load(at + LaneMemory::kLength * stride),
          load(at + LaneMemory::kConeAmplitude * stride)};
}

[[nodiscard]] HWY_INLINE CircleLanes load_circle(const LaneMemory& memory, std::uint32_t i) {
  const double* const at = memory.circle.row(i);
  const std::size_t stride = memory.circle.stride();
  return {load(at + LaneMemory::kZ0 * stride),      load(at + LaneMemory::kDz * stride),
          load(at + LaneMemory::kC0 * stride),      load(at + LaneMemory::kC2 * stride),
          load(at + LaneMemory::kCMiddle * stride), load(at + LaneMemory::kRing * stride),
          load(at + LaneMemory::kInverse * stride), load(at + LaneMemory::kCircleAmplitude * stride)};
}

[[nodiscard]] HWY_INLINE SegmentLanes load_segment(const LaneMemory& memory, std::uint32_t i) {
  const double* const at = memory.segment.row(i);
  const std::size_t stride = memory.segment.stride();
  return {load(at + LaneMemory::kBefore * stride),    load(at + LaneMemory::kBehind * stride),
          load(at + LaneMemory::kSegmentDx * stride), load(at + LaneMemory::kS0 * stride),
          load(at + LaneMemory::kS2 * stride),        load(at + LaneMemory::kSMiddle * stride),
          load(at + LaneMemory::kWhole * stride),     load(at + LaneMemory::kSegmentAmplitude * stride)};
}

[[nodiscard]] HWY_INLINE RingLanes load_ring(const LaneMemory& memory, std::uint32_t i) {
  const double* const at = memory.ring.row(i);
  const std::size_t stride = memory.ring.stride();
  return {load(at + LaneMemory::kRingZ0 * stride),       load(at + LaneMemory::kRingDz * stride),
          load(at + LaneMemory::kR0 * stride),           load(at + LaneMemory::kR2 * stride),
          load(at + LaneMemory::kRMiddle * stride),      load(at + LaneMemory::kRadiusOfRing * stride),
          load(at + LaneMemory::kRingAmplitude * stride)};
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
