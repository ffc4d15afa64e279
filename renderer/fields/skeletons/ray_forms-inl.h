// The ray forms of all skeletons that have one, compiled for the current SIMD target. They are the second parts of the
// skeletons' files.
#if defined(ISL_RENDERER_FIELDS_SKELETONS_RAY_FORMS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_SKELETONS_RAY_FORMS_INL_H_
#undef ISL_RENDERER_FIELDS_SKELETONS_RAY_FORMS_INL_H_
#else
#define ISL_RENDERER_FIELDS_SKELETONS_RAY_FORMS_INL_H_
#endif

#include "renderer/fields/skeletons/ray_form-inl.h"
#include "renderer/fields/skeletons/skeletons.h"

#include <array>
#include <limits>
#include <type_traits>

#define ISL_RAY_FORMS
#include "renderer/fields/skeletons/skeleton_files.h"
#undef ISL_RAY_FORMS

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

template <class Shape>
inline constexpr bool kHasRayForm = !std::is_void_v<typename RayFormOf<Shape>::type>;

/// Calls use(std::type_identity<Shape>()) with the skeleton's class, if it has a ray form.
template <class Use>
HWY_INLINE void with_ray_form(scene::Skeleton skeleton, const Use& use) {
  switch (skeleton) {
#define ISL_SKELETON(word, Type, record)                                                    \
  case scene::Skeleton::word:                                                               \
    static_assert(kHasRayForm<Type> != HasPieces<Type>, #Type " has pieces or a ray form"); \
    if constexpr (kHasRayForm<Type>) use(std::type_identity<Type>());                       \
    break;
#include "renderer/scene/skeletons.def"
#undef ISL_SKELETON
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
