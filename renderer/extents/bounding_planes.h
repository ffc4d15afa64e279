// The box around an intersection of half-spaces.
#pragma once

#include "renderer/scene/solids.h"
#include "renderer/scene/transform.h"

#include <ImathBox.h>

#include <vector>

namespace isl::render {

/// The border of the half-space n·x ≤ d; n of unit length.
struct BoundingPlane {
  scene::Vec3 normal;
  double distance;
};

/// The border of a solid that is a plane, in the space it is placed into. `is_turned`: what counts is the half-space
/// beyond it.
[[nodiscard]] BoundingPlane bounding_plane(const scene::Solid& plane, const scene::Transform& parent_from_object,
                                           bool is_turned);

/// A box that holds the intersection of half-spaces. A side is infinite if the intersection is endless there; if it is
/// endless anywhere, only half-spaces that are parallel to the axes bound it. The time grows with the cube of their
/// number, so no more than the first 64 are looked at, which makes the box no smaller.
[[nodiscard]] Imath::Box3d box_around(const std::vector<BoundingPlane>& planes);

}  // namespace isl::render
