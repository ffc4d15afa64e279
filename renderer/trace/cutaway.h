// `cutaway_textures`: what a cut surface without a texture of its own looks like.
#pragma once

#include "renderer/compiled/compiled_scene.h"

namespace isl::render {

/// For a point in the tree's space on a leaf without a texture: the first solid or blob of its `cutaway` group that has
/// one, is not itself taken away, and holds the point; the first of them where none does (a blob is not asked). Null
/// where there is no such group or nothing in it.
[[nodiscard]] const CsgLeaf* leaf_cut_away(const CompiledScene& scene, const CsgTree& tree, const CsgLeaf& leaf,
                                           const Vec3& point);

}  // namespace isl::render
