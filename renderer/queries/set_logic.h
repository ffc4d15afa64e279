// Set operations as "and" and "or" of their children's insides. The outside of a group is asked for by asking the
// children for theirs, because open surfaces have neither.
#pragma once

#include "renderer/scene/objects.h"

#include <cstddef>

namespace isl::render {

/// True if the inside of a group, or its outside, is that of all children; false if that of any is enough.
[[nodiscard]] inline bool wants_all(const scene::Group& group, bool is_inverse) {
  const bool is_union = group.operation == scene::Operation::unite || group.operation == scene::Operation::merge;
  return is_union == is_inverse;
}
/// True if a child is asked for its outside.
[[nodiscard]] inline bool is_asked_inverse(const scene::Group& group, std::size_t child, bool is_inverse) {
  return is_inverse != (group.operation == scene::Operation::subtract && child > 0);
}

}  // namespace isl::render
