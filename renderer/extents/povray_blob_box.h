// The box that POV-Ray computes for a blob of its own components.
#pragma once

#include "renderer/scene/database.h"

#include <ImathBox.h>

#include <optional>

namespace isl::render {

/// The box in the blob's own space, for `min_extent` and `max_extent` in scenes that place objects by it; nothing if a
/// component is not one of POV-Ray's.
[[nodiscard]] std::optional<Imath::Box3d> povray_box_of_blob(const scene::Database& database, const scene::Blob& blob);

}  // namespace isl::render
