// Haines' sphereflake (SPD `balls`, public domain) as a database, made in C++ so that tests of the renderer do not need
// the language.
#pragma once

#include "renderer/scene/database.h"

namespace isl::test {

/// One blob with Σ 9^k (k = 0 … levels) `point` components; root radius 0.5 at the origin, z up as in the SPD, one
/// texture a level.
[[nodiscard]] scene::Database sphereflake(int levels, const scene::Kernel& kernel);

}  // namespace isl::test
