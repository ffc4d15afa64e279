// The box of a blob.
#pragma once

#include "renderer/fields/kernels/kernel_constants.h"
#include "renderer/scene/database.h"

#include <ImathBox.h>

#include <vector>

namespace isl::render {

/// A box that contains the blob's whole surface, in the blob's own space; empty if it has none. `kernels` are the
/// constants of the database's kernels, by index.
[[nodiscard]] Imath::Box3d box_of_blob(const scene::Database& database, const std::vector<KernelConstants>& kernels,
                                       const scene::Blob& blob);

}  // namespace isl::render
