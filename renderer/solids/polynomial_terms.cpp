#include "renderer/solids/polynomial.h"

#include <cmath>

namespace isl::render {

double terms_over_gradient(const PreparedPolynomial& polynomial, const Vec3& point) noexcept {
  const double* coefficient = polynomial.coefficients.data();
  double in_x = 0, size_x = 0;
  Vec3 slope_x(0);
  for (int i = 0; i <= polynomial.order; ++i) {
    double in_y = 0, size_y = 0;
    Vec3 slope_y(0);
    for (int j = 0; j <= i; ++j) {
      double in_z = 0, slope_z = 0, size_z = 0;
      for (int k = 0; k <= j; ++k) {
        slope_z = slope_z * point.z + in_z;
        size_z = size_z * std::abs(point.z) + std::abs(*coefficient);
        in_z = in_z * point.z + *coefficient++;
      }
      slope_y = slope_y * point.y + Vec3(0, in_y, slope_z);
      size_y = size_y * std::abs(point.y) + size_z;
      in_y = in_y * point.y + in_z;
    }
    slope_x = slope_x * point.x + Vec3(in_x, slope_y.y, slope_y.z);
    size_x = size_x * std::abs(point.x) + size_y;
    in_x = in_x * point.x + in_y;
  }
  const double length = slope_x.length();
  return length > 0 && std::isfinite(length) && std::isfinite(size_x) ? size_x / length : 0;
}

}  // namespace isl::render
