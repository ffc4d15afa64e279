// The box of a blob.
#pragma once

#include "renderer/fields/kernels/kernel_constants.h"
#include "renderer/scene/database.h"

#include <ImathBox.h>

#include <vector>

namespace isl::render {

/// In the blob's own space; holds its whole surface, empty when it has none. `kernels` are those of the database.
[[nodiscard]] Imath::Box3d box_of_blob(const scene::Database& database, const std::vector<KernelConstants>& kernels,
                                       const scene::Blob& blob);

}  // namespace isl::render
