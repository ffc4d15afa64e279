// `cutaway_textures`: the texture of a cut surface that has none of its own.
#pragma once

#include "renderer/compiled/compiled_scene.h"

namespace isl::render {

/// For a point in the tree's space on a leaf without a texture: the first solid or blob of its `cutaway` group that has
/// a texture, is not itself subtracted, and holds the point; if none holds it (a blob is not asked), the first of them.
/// Null if there is no such group or nothing in it.
[[nodiscard]] const CsgLeaf* leaf_cut_away(const CompiledScene& scene, const CsgTree& tree, const CsgLeaf& leaf,
                                           const Vec3& point);

}  // namespace isl::render
