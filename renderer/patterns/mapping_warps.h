// Warps that wrap the plane of x and y around a cylinder, sphere, torus, plane or cube: one full turn, or one side, has
// length 1, and z is the distance from the middle. For orientations off the axes POV-Ray's map is not a rotation; this
// one is the same.
#pragma once

#include "renderer/scene/warp.h"

namespace isl::render {

[[nodiscard]] scene::Vec3 mapped(const scene::MappingWarp& warp, const scene::Vec3& point) noexcept;

}  // namespace isl::render
