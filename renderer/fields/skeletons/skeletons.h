// All skeletons, and the way to get from a skeleton's name to its class.
#pragma once

#include "base/check.h"
#include "renderer/fields/skeletons/skeleton_files.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <vector>

namespace isl::render {

template <class None, class... Columns>
struct ColumnsBehind {
  using type = std::tuple<Columns...>;
};
/// A tuple with one column for each skeleton.
using SkeletonColumns = ColumnsBehind<void
#define ISL_SKELETON(word, Type, record) , std::vector<Type>
#include "renderer/scene/skeletons.def"
#undef ISL_SKELETON
                                      >::type;

/// Calls use(std::type_identity<Type>()) with the skeleton's class and returns the result.
template <class Use>
auto with_skeleton_type(scene::Skeleton skeleton, const Use& use) {
  switch (skeleton) {
#define ISL_SKELETON(word, Type, record) \
  case scene::Skeleton::word:            \
    return use(std::type_identity<Type>());
#include "renderer/scene/skeletons.def"
#undef ISL_SKELETON
  }
  ISL_CHECK(false, "skeleton {}", static_cast<int>(skeleton));
}

/// A skeleton that is unbounded in at least two directions. Its members are a point and a normal, `at` and `normal`,
/// the borders of its field, kBorders, and kFillsBehind: whether the field behind the first one is constant or 0.
template <class Shape>
concept Endless = requires {
  Shape::kBorders;
};

/// Like with_skeleton_type(), for an Endless skeleton only.
template <class Use>
auto with_endless_type(scene::Skeleton skeleton, const Use& use) {
  switch (skeleton) {
#define ISL_SKELETON(word, Type, record)      \
  case scene::Skeleton::word:                 \
    if constexpr (Endless<Type>) {            \
      return use(std::type_identity<Type>()); \
    }                                         \
    break;
#include "renderer/scene/skeletons.def"
#undef ISL_SKELETON
  }
  ISL_CHECK(false, "skeleton {} has an end", static_cast<int>(skeleton));
}

/// The greatest number of pieces into which a ray can divide any skeleton.
inline constexpr std::size_t kMostPieces = [] {
  std::size_t most = 0;
  const auto count = [&]<class Shape>(std::type_identity<Shape>) {
    if constexpr (HasPieces<Shape>) most = std::max(most, Shape::kMostPieces);
  };
#define ISL_SKELETON(word, Type, record) count(std::type_identity<Type>());
#include "renderer/scene/skeletons.def"
#undef ISL_SKELETON
  return most;
}();

}  // namespace isl::render
