// A an ellipsoid's, so positive definite: its centre is m = −A⁻¹b/2, and with k = mᵀAm − c it is (p − m)ᵀA(p − m) ≤ k,
// which reaches d·m + √(k dᵀA⁻¹d).
#include "renderer/solids/quadric_reach.h"

#include "renderer/solids/kinds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isl::render {

double ellipsoid_reach(const std::vector<double>& q, const scene::Vec3& direction) {
  // Terms: x², xy, xz, x, y², yz, y, z², z, 1. Columns of the symmetric A:
  const Vec3 a0(q[0], q[1] / 2, q[2] / 2), a1(q[1] / 2, q[4], q[5] / 2), a2(q[2] / 2, q[5] / 2, q[7]);
  const Vec3 c0 = a1.cross(a2), c1 = a2.cross(a0), c2 = a0.cross(a1);
  const double determinant = a0.dot(c0);
  const bool is_definite = a0.x > 0 && a0.x * a1.y - a0.y * a0.y > 0 && determinant > 0;
  if (!is_definite) return std::numeric_limits<double>::infinity();
  const auto solved = [&](const Vec3& v) { return Vec3(c0.dot(v), c1.dot(v), c2.dot(v)) / determinant; };
  const Vec3 b(q[3], q[6], q[8]);
  const Vec3 centre = solved(b) * -0.5;
  const double k = -centre.dot(b) / 2 - q[9];  // Am = −b/2
  return direction.dot(centre) + std::sqrt(std::max(k, 0.0) * direction.dot(solved(direction)));
}

Box polynomial_bounds(const PreparedPolynomial& polynomial) noexcept {
  if (polynomial.order != 2) return {Vec3(-polynomial.cube), Vec3(polynomial.cube)};
  Box box;
  for (int i = 0; i < 3; ++i) {
    Vec3 axis(0);
    axis[i] = 1;
    // The formula's own rounding: some 30 operations whose terms are of the size of the result and the centre.
    const double high = ellipsoid_reach(polynomial.coefficients, axis),
                 low = -ellipsoid_reach(polynomial.coefficients, -axis);
    const double margin = 0x1p-46 * (std::abs(high) + std::abs(low));
    box.min[i] = low - (std::isfinite(margin) ? margin : 0);
    box.max[i] = high + (std::isfinite(margin) ? margin : 0);
  }
  return box;
}

}  // namespace isl::render
