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
/// A column of each.
using SkeletonColumns = ColumnsBehind<void
#define ISL_SKELETON(word, Type, record) , std::vector<Type>
#include "renderer/scene/skeletons.def"
#undef ISL_SKELETON
                                      >::type;

/// use(std::type_identity<Type>()) with the skeleton's class.
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

/// Whether it reaches everywhere, in two directions at least: it has a place and a normal, `at` and `normal`, the
/// borders of its field and what is behind them.
template <class Shape>
concept Endless = requires {
  Shape::kBorders;
};

/// The same of a skeleton that has no end.
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

/// No ray makes more pieces of any skeleton.
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
