// Whether a polynomial's surface ends somewhere, and where: what spares rays that pass by, and keeps grids small.
#pragma once

#include "renderer/solids/solid_details.h"

namespace isl::render {

/// Half the side of a cube about the origin that the set where the polynomial is ≤ 0 lies in; infinite where there is
/// none, or none is found.
[[nodiscard]] double cube_of(const PreparedPolynomial& polynomial);

}  // namespace isl::render
