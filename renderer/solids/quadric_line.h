// The usual case of a line through a quadric: two crossings, or none, that no rounding can move past one another.
#pragma once

#include "renderer/solids/solid.h"

#include <optional>

namespace isl::render {

/// What polynomial_crossings() finds for a polynomial of order 2, or nothing where rounding may decide: near tangents,
/// near the surface, or along directions in which the quadric has no curvature.
[[nodiscard]] std::optional<Crossings> plain_quadric_crossings(const PreparedPolynomial& quadric, const Vec3& origin,
                                                               const Vec3& direction, bool starts_on_surface) noexcept;

}  // namespace isl::render
