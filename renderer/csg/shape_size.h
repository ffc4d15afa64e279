// The size of the numbers that a shape's surface is computed from.
#pragma once

#include "renderer/scene/database.h"

namespace isl::render {

/// The largest coordinate among the numbers that describe a solid or blob, in its own space.
[[nodiscard]] double shape_size(const scene::Database& database, scene::Object::Kind kind, std::uint32_t shape);

}  // namespace isl::render
