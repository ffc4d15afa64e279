#include "renderer/csg/spread.h"

#include "renderer/csg/shape_size.h"

#include <cmath>

namespace isl::render {

using scene::Vec3;

double frobenius_norm(const scene::Matrix& m) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) sum += m[i][j] * m[i][j];
  }
  return std::sqrt(sum);
}

/// For every unit normal n, |n|·e ≤ √3 (r + size), where r is the largest coordinate of the reach.
Spread spread_of_shape(double size) { return {std::sqrt(3.0), std::sqrt(3.0) * size}; }

Spread spread_through(const scene::Transform& map, const Spread& inner) {
  const Vec3 offset(map.inverse[3][0], map.inverse[3][1], map.inverse[3][2]);
  // No coordinate of a vector is stretched by more than √3 times the norm; distances are multiplied by at most the norm
  // on the way back.
  const double in = std::sqrt(3.0) * frobenius_norm(map.inverse), out = frobenius_norm(map.matrix);
  return {out * inner.factor * in, out * inner.at(largest_coordinate(offset))};
}

}  // namespace isl::render
