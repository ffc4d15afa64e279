// The usual case of a line through a quadric: two crossings, or none, that no rounding can move past one another.
#pragma once

#include "renderer/solids/solid.h"

#include <cmath>

namespace isl::render {

/// A, B and C of quadric_line.cpp are off by less than this times the sizes of their terms.
inline constexpr double kTermRounding = 0x1p-47;
/// The sign of a value decides about roots only if the value is larger than its rounding by this factor. Roots that
/// follow from a smaller value would have fewer digits than those that the general method finds.
inline constexpr double kClear = 0x1p16;

/// The sums of the sizes of a quadric's coefficients of each order.
struct QuadricSizes {
  double second, first, constant;

  explicit QuadricSizes(const PreparedPolynomial& quadric) {
    const double* const c = quadric.coefficients.data();
    second = std::abs(c[0]) + std::abs(c[1]) + std::abs(c[2]) + std::abs(c[4]) + std::abs(c[5]) + std::abs(c[7]);
    first = std::abs(c[3]) + std::abs(c[6]) + std::abs(c[8]);
    constant = std::abs(c[9]);
  }
};

/// Finds what polynomial_crossings() finds for a polynomial of order 2. False, and nothing found, where rounding may
/// decide: near tangents, near the surface, or along directions in which the quadric has no curvature.
[[nodiscard]] bool find_plain_crossings(const PreparedPolynomial& quadric, const Vec3& origin, const Vec3& direction,
                                        bool starts_on_surface, Crossings& found) noexcept;

}  // namespace isl::render
