// Polynomials of x, y and z along lines and at points, for the algebraic solids (algebraic.cpp).
#pragma once

#include "renderer/solids/solid_type.h"

namespace isl::render {

/// The contract is that of boundary() or, if only the first is wanted, crossings_to_first() in solid.h; the surface has
/// one part, kSide.
[[nodiscard]] Crossings polynomial_crossings(const PreparedPolynomial& polynomial, const Vec3& origin,
                                             const Vec3& direction, std::uint32_t start_part, Wanted wanted,
                                             const Stretch& stretch = {}) noexcept;

/// Zero at a singular point, which has no normal.
[[nodiscard]] Vec3 polynomial_normal(const PreparedPolynomial& polynomial, const Vec3& point) noexcept;

/// The contract is that of the function of the same name in solid.h.
[[nodiscard]] double terms_over_gradient(const PreparedPolynomial& polynomial, const Vec3& point) noexcept;

}  // namespace isl::render
