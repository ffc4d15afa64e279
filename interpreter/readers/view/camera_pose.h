// The effect of `angle`, `look_at` and `sky` on a camera's vectors. Knows no text: the camera's reader decides when
// each applies.
#pragma once

#include "renderer/scene/camera.h"

namespace isl::interpreter {

/// Sets the length of direction so that the picture spans `degrees` between its left and its right edge; below 180.
void set_horizontal_angle(scene::Camera& camera, double degrees);

/// Turns the camera to `target`, which must differ from its location, with `sky` above it. Keeps the vectors' lengths.
void look_at(scene::Camera& camera, const scene::Vec3& target, const scene::Vec3& sky);

}  // namespace isl::interpreter
