// Visits the fields of a cell along a ray, octet by octet: the one walk over runs, kernels and columns for those that sum
// bounds of all fields (lane_range-inl.h, lane_slope-inl.h, lane_bend-inl.h). They differ in what they make of an octet
// and are visitors:
//   add_quadratics(kernel, run, i)    the octet of column i, where v is a quadratic in t
//   add_shape(kernel, run, lanes)     cones and circles
//   add_curve(window, lanes)          convolved segments and rings
#if defined(ISL_RENDERER_FIELDS_RAY_LANE_WALK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_RAY_LANE_WALK_INL_H_
#undef ISL_RENDERER_FIELDS_RAY_LANE_WALK_INL_H_
#else
#define ISL_RENDERER_FIELDS_RAY_LANE_WALK_INL_H_
#endif

#include "renderer/fields/kernels/kernels-inl.h"
#include "renderer/fields/ray/lane_columns-inl.h"

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// Calls use(window, lanes) for every octet of a run of convolved curves.
template <class Use>
HWY_INLINE void for_each_curve(const LaneMemory& memory, const LaneRun& run, const Use& use) {
  with_window(*run.kernel, [&](const auto& window) HWY_ATTR {
    for (std::uint32_t i = run.segments.first; i < run.segments.last; i += kOctet) use(window, load_segment(memory, i));
    for (std::uint32_t i = run.rings.first; i < run.rings.last; i += kOctet) use(window, load_ring(memory, i));
  });
}

template <class Visitor>
HWY_INLINE void visit_lanes(const LaneMemory& memory, Visitor& visitor) {
  for (const LaneRun& run : memory.runs) {
    if (run.kernel->is_convolved) {
      for_each_curve(memory, run,
                     [&](const auto& window, const auto& lanes) HWY_ATTR { visitor.add_curve(window, lanes); });
      continue;
    }
    with_kernel(*run.kernel, [&](const auto& kernel) HWY_ATTR {
      for (std::uint32_t i = run.quadratics.first; i < run.quadratics.last; i += kOctet) {
        visitor.add_quadratics(kernel, run, i);
      }
      for (std::uint32_t i = run.cones.first; i < run.cones.last; i += kOctet) {
        visitor.add_shape(kernel, run, load_cone(memory, i));
      }
      for (std::uint32_t i = run.circles.first; i < run.circles.last; i += kOctet) {
        visitor.add_shape(kernel, run, load_circle(memory, i));
      }
    });
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
