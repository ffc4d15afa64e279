// The size of the numbers that a shape's surface is computed from.
#pragma once

#include "renderer/scene/database.h"

#include <algorithm>
#include <cmath>

namespace isl::render {

[[nodiscard]] inline double largest_coordinate(const scene::Vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The largest coordinate among the numbers that describe a solid or blob, in its own space.
[[nodiscard]] double shape_size(const scene::Database& database, scene::Object::Kind kind, std::uint32_t shape);

}  // namespace isl::render
