// From a convolution's constants to its window.
#if defined(ISL_RENDERER_FIELDS_CONVOLUTIONS_WINDOWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_CONVOLUTIONS_WINDOWS_INL_H_
#undef ISL_RENDERER_FIELDS_CONVOLUTIONS_WINDOWS_INL_H_
#else
#define ISL_RENDERER_FIELDS_CONVOLUTIONS_WINDOWS_INL_H_
#endif

#include "renderer/fields/convolutions/ring_lanes-inl.h"
#include "renderer/fields/convolutions/segment_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// Calls `use` with the window of these constants.
template <class Use>
HWY_INLINE auto with_window(const KernelConstants& constants, Use&& use) {
  if (constants.shape == scene::KernelShape::quartic) return use(QuarticWindow(constants));
  return use(CauchyWindow(constants));
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
