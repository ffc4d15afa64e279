// The depth to which a scene's values may hold one another.
#pragma once

#include <cstdint>

namespace isl::scene {

/// Greatest depth of pigments, normals and textures within one another through maps, lists, patterns and functions, of
/// functions that call functions, and of arrays within arrays. The interpreter sees to it (interpreter/value_depths.h),
/// so that everything that walks over these values may recurse. The deepest frames are those of functions whose
/// patterns are functions again: some 33 kB a level for the largest (Function::kMaxFrame), 2.1 MB in all, of the 4 MB
/// of stack that a rendering thread has. Objects may hold one another to any depth: walks over groups do not recurse.
inline constexpr std::uint32_t kMaxValueDepth = 64;

}  // namespace isl::scene
