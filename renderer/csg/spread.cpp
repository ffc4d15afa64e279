#include "renderer/csg/spread.h"

#include "renderer/csg/shape_size.h"

#include <algorithm>
#include <cmath>

namespace isl::render {

using scene::Vec3;

namespace {

/// The greatest sum of absolute entries that one coordinate of a vector times the linear part is made from: no largest
/// coordinate is multiplied by more.
double coordinate_stretch(const scene::Matrix& m) {
  double most = 0;
  for (int i = 0; i < 3; ++i) most = std::max(most, std::abs(m[0][i]) + std::abs(m[1][i]) + std::abs(m[2][i]));
  return most;
}

}  // namespace

double length_stretch(const scene::Matrix& m) {
  return std::sqrt(coordinate_stretch(m) * coordinate_stretch(m.transposed()));
}

/// For every unit normal n, |n|·e ≤ √3 (r + size), where r is the largest coordinate of the reach.
Spread spread_of_shape(double size) { return {std::sqrt(3.0), std::sqrt(3.0) * size}; }

Spread spread_through(const scene::Transform& map, const Spread& inner) {
  const Vec3 offset(map.inverse[3][0], map.inverse[3][1], map.inverse[3][2]);
  const double in = coordinate_stretch(map.inverse), out = length_stretch(map.matrix);
  return {out * inner.factor * in, out * inner.at(largest_coordinate(offset))};
}

}  // namespace isl::render
