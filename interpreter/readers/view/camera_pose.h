// How `angle`, `look_at` and `sky` change a camera's vectors. Knows no text: the camera's reader says when each
// applies.
#pragma once

#include "renderer/scene/camera.h"

namespace isl::interpreter {

/// Sets the length of direction so that the picture spans `degrees` between its left and its right edge; below 180.
void set_horizontal_angle(scene::Camera& camera, double degrees);

/// Turns the camera to `target`, which is not its location, with `sky` above it. The lengths of the vectors stay.
void look_at(scene::Camera& camera, const scene::Vec3& target, const scene::Vec3& sky);

}  // namespace isl::interpreter
