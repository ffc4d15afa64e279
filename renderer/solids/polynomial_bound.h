// Bounds of algebraic solids. With a bound, rays that miss the solid cost little, and grids stay small.
#pragma once

#include "renderer/solids/solid_details.h"

namespace isl::render {

/// Half the side of a cube about the origin that contains the set where the polynomial is ≤ 0; infinite if the set is
/// unbounded or no bound is found.
[[nodiscard]] double cube_of(const PreparedPolynomial& polynomial);

}  // namespace isl::render
