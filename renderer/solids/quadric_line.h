// The usual case of a line through a quadric: two crossings, or none, that no rounding can move past one another.
#pragma once

#include "renderer/solids/solid.h"

namespace isl::render {

/// Finds what polynomial_crossings() finds for a polynomial of order 2. False, and nothing found, where rounding may
/// decide: near tangents, near the surface, or along directions in which the quadric has no curvature.
[[nodiscard]] bool find_plain_crossings(const PreparedPolynomial& quadric, const Vec3& origin, const Vec3& direction,
                                        bool starts_on_surface, Crossings& found) noexcept;

}  // namespace isl::render
