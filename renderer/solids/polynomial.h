// Polynomials of x, y and z along lines and at points, for the solids that they describe (algebraic.cpp).
#pragma once

#include "renderer/solids/solid.h"

namespace isl::render {

/// As crossings(): the surface is one part, kSide.
[[nodiscard]] Crossings polynomial_crossings(const PreparedPolynomial& polynomial, const Vec3& origin,
                                             const Vec3& direction, std::uint8_t start_part) noexcept;

/// Zero where there is none: at a singular point.
[[nodiscard]] Vec3 polynomial_normal(const PreparedPolynomial& polynomial, const Vec3& point) noexcept;

/// As the function of the same name in solid.h.
[[nodiscard]] double terms_over_gradient(const PreparedPolynomial& polynomial, const Vec3& point) noexcept;

}  // namespace isl::render
