// How well the terms of a polynomial determine its surface.
#pragma once

#include "renderer/solids/solid_details.h"

namespace isl::render {

/// The sum of the absolute terms at a point of the surface over the length of the gradient: a rounding of the terms by
/// a share moves the surface by this share of that length. Zero where the gradient is.
[[nodiscard]] double terms_over_gradient(const PreparedPolynomial& polynomial, const Vec3& point) noexcept;

}  // namespace isl::render
