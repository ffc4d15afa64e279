// Warps that wrap the plane of x and y around a cylinder, sphere, torus, plane or cube: one turn, or one side, is as
// long as 1, and z is the distance from the middle. What POV-Ray makes of orientations off the axes is no rotation;
// ours is the same.
#pragma once

#include "renderer/scene/warp.h"

namespace isl::render {

[[nodiscard]] scene::Vec3 mapped(const scene::MappingWarp& warp, const scene::Vec3& point) noexcept;

}  // namespace isl::render
