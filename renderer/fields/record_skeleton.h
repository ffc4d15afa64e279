// The skeleton of a component's record.
#pragma once

#include "renderer/fields/skeletons/skeletons.h"

#include <algorithm>

namespace isl::render {

[[nodiscard]] inline bool has_ends(scene::Skeleton skeleton) {
  return skeleton == scene::Skeleton::segment || skeleton == scene::Skeleton::cone;
}

/// A component without what does not matter to it; without length it is a point.
[[nodiscard]] inline scene::Component simplified(scene::Component c) {
  if (has_ends(c.skeleton) && c.a == c.b) {
    if (c.skeleton == scene::Skeleton::cone) c.radius_a = std::max(c.radius_a, c.radius_b);
    c.skeleton = scene::Skeleton::point;
  }
  if (c.skeleton == scene::Skeleton::point) c.b = c.a;
  if (c.skeleton == scene::Skeleton::point || c.skeleton == scene::Skeleton::segment) c.radius_b = c.radius_a;
  return c;
}

/// Calls `use` with the skeleton of a record, in its own space.
template <class Use>
auto with_skeleton_of(const scene::Blob& blob, const scene::Component& component, const Use& use) {
  const scene::Component c = simplified(component);
  return with_skeleton_type(c.skeleton, [&](auto type) { return use(typename decltype(type)::type(blob, c)); });
}

}  // namespace isl::render
