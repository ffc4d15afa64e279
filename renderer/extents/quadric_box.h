// The part of a box that a quadric may fill, as a box.
#pragma once

#include "renderer/scene/solids.h"
#include "renderer/scene/transform.h"

#include <ImathBox.h>

namespace isl::render {

/// A box, no larger than the given one, that contains its points inside the quadric (a polynomial of order 2), which
/// is placed by the transform. Sides may be infinite.
[[nodiscard]] Imath::Box3d narrowed_by_quadric(const Imath::Box3d& box, const scene::Polynomial& quadric,
                                               const scene::Transform& box_from_quadric);

}  // namespace isl::render
