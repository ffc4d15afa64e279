// All skeletons, and the way to get from a skeleton's name to its class.
#pragma once

#include "base/check.h"
#include "renderer/fields/skeletons/box.h"
#include "renderer/fields/skeletons/circle.h"
#include "renderer/fields/skeletons/cone.h"
#include "renderer/fields/skeletons/plane.h"
#include "renderer/fields/skeletons/point.h"
#include "renderer/fields/skeletons/segment.h"
#include "renderer/fields/skeletons/sheet.h"
#include "renderer/fields/skeletons/triangle.h"

#include <tuple>
#include <type_traits>
#include <vector>

namespace isl::render {

template <class None, class... Columns>
struct ColumnsBehind {
  using type = std::tuple<Columns...>;
};
/// A column of each.
using SkeletonColumns = ColumnsBehind<void
#define ISL_SKELETON(word, Type) , std::vector<Type>
#include "renderer/scene/skeletons.def"
#undef ISL_SKELETON
                                      >::type;

/// use(std::type_identity<Type>()) with the skeleton's class.
template <class Use>
auto with_skeleton_type(scene::Skeleton skeleton, const Use& use) {
  switch (skeleton) {
#define ISL_SKELETON(word, Type) \
  case scene::Skeleton::word:    \
    return use(std::type_identity<Type>());
#include "renderer/scene/skeletons.def"
#undef ISL_SKELETON
  }
  ISL_CHECK(false, "skeleton {}", static_cast<int>(skeleton));
}

}  // namespace isl::render
