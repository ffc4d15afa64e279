// Makes the skeleton of a component's record.
#pragma once

#include "renderer/fields/skeletons/skeletons.h"

#include <algorithm>
#include <cstddef>

namespace isl::render {

/// The component in normal form: a skeleton between two equal ends becomes a point, and members that the skeleton does
/// not use (b, radius_b) are copies of a and radius_a.
[[nodiscard]] inline scene::Component simplified(scene::Component c) {
  unsigned parts = scene::kSkeletonRecords[static_cast<std::size_t>(c.skeleton)];
  if ((parts & scene::kEndB) != 0 && c.a == c.b) {
    if ((parts & scene::kRadiusB) != 0) c.radius_a = std::max(c.radius_a, c.radius_b);
    c.skeleton = scene::Skeleton::point;
    parts = 0;
  }
  if ((parts & (scene::kPointB | scene::kEndB | scene::kDirectionB)) == 0) c.b = c.a;
  if ((parts & scene::kRadiusB) == 0) c.radius_b = c.radius_a;
  return c;
}

/// Calls `use` with the skeleton of a record, in the component's own space, and returns its result.
template <class Use>
auto with_skeleton_of(const scene::Blob& blob, const scene::Component& component, const Use& use) {
  const scene::Component c = simplified(component);
  return with_skeleton_type(c.skeleton, [&](auto type) { return use(typename decltype(type)::type(blob, c)); });
}

}  // namespace isl::render
