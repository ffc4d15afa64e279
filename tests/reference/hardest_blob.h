// Blobs of which few rays can be decided: hardnesses at both ends of what is allowed, strengths that cancel, and maps
// of condition 10⁸. Rays at them show what a ray takes at most.
#pragma once

#include "renderer/scene/database.h"
#include "tests/reference/random_scenes.h"

#include <cstdint>

namespace isl::reference {

/// Beyond the bound of a ray, a search takes steps that are not counted: nodes at the ends of cells, polished roots,
/// and what a spent ray still looks at. A ray meets some hundred cells, and takes at most some hundred evaluations of
/// ten fields in each.
inline constexpr std::uint64_t kEvaluationsBeyondBound = 1'000'000;

/// Eight components or more of one hardness, the hardest that there are in turn by `number`; half of them carve what
/// the other half adds, to a part in 10⁹.
[[nodiscard]] scene::Database hardest_blob(RandomSource& random, std::uint64_t number);

}  // namespace isl::reference
