// Choose the window of a convolution by its constants, and the lanes of a convolved skeleton by its type.
#if defined(ISL_RENDERER_FIELDS_CONVOLUTIONS_WINDOWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_CONVOLUTIONS_WINDOWS_INL_H_
#undef ISL_RENDERER_FIELDS_CONVOLUTIONS_WINDOWS_INL_H_
#else
#define ISL_RENDERER_FIELDS_CONVOLUTIONS_WINDOWS_INL_H_
#endif

#include "renderer/fields/convolutions/ring_lanes-inl.h"
#include "renderer/fields/convolutions/segment_lanes-inl.h"
#include "renderer/fields/skeletons/skeletons.h"

#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// Calls `use` with the window of these constants.
template <class Use>
HWY_INLINE auto with_window(const KernelConstants& constants, Use&& use) {
  if (constants.shape == scene::KernelShape::quartic) return use(QuarticWindow(constants));
  return use(CauchyWindow(constants));
}

/// Calls use(std::type_identity<Shape>()) with the skeleton's class, if it can be convolved.
template <class Use>
HWY_INLINE void with_curve_form(scene::Skeleton skeleton, const Use& use) {
  switch (skeleton) {
#define ISL_SKELETON(word, Type, record)                                                              \
  case scene::Skeleton::word:                                                                         \
    if constexpr (!std::is_void_v<typename CurveFormOf<Type>::type>) use(std::type_identity<Type>()); \
    break;
#include "renderer/scene/skeletons.def"
#undef ISL_SKELETON
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
