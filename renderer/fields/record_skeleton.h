// The skeleton of a component's record.
#pragma once

#include "renderer/fields/skeletons/skeletons.h"

#include <algorithm>

namespace isl::render {

/// A component without what does not matter to it; without length it is a point.
[[nodiscard]] inline scene::Component simplified(scene::Component c) {
  if (has(c.skeleton, scene::kEndB) && c.a == c.b) {
    if (has(c.skeleton, scene::kRadiusB)) c.radius_a = std::max(c.radius_a, c.radius_b);
    c.skeleton = scene::Skeleton::point;
  }
  if (!has_b(c.skeleton)) c.b = c.a;
  if (!has(c.skeleton, scene::kRadiusB)) c.radius_b = c.radius_a;
  return c;
}

/// Calls `use` with the skeleton of a record, in its own space.
template <class Use>
auto with_skeleton_of(const scene::Blob& blob, const scene::Component& component, const Use& use) {
  const scene::Component c = simplified(component);
  return with_skeleton_type(c.skeleton, [&](auto type) { return use(typename decltype(type)::type(blob, c)); });
}

}  // namespace isl::render
