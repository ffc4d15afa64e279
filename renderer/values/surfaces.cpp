#include "renderer/values/surfaces.h"

#include <algorithm>
#include <cmath>

namespace isl::values {

double radius(const double* p) { return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]); }

double sphere(const double* p) { return radius(p) - p[3]; }

double azimuth(const double* p) { return std::atan2(p[0], p[2]); }

double polar_angle(const double* p) { return std::atan2(std::sqrt(p[0] * p[0] + p[2] * p[2]), p[1]); }

double ellipsoid(const double* p) {
  const double scaled[] = {p[0] * p[3], p[1] * p[4], p[2] * p[5]};
  return radius(scaled);
}

double torus(const double* p) {
  const double from_circle = std::sqrt(p[0] * p[0] + p[2] * p[2]) - p[3];
  return std::sqrt(from_circle * from_circle + p[1] * p[1]) - p[4];
}

/// Distance to the box that the corners' spheres roll in, less their radius; zero inside of that box. POV-Ray takes off
/// another millionth, so that a box without rounding has an inside.
double rounded_box(const double* p) {
  constexpr double kInside = 1e-6;
  double outside[3];
  for (int i = 0; i < 3; ++i) outside[i] = std::max(std::abs(p[i]) - (p[4 + i] - p[3]), 0.0);
  return radius(outside) - p[3] - kInside;
}

/// Barr's: ((|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n))^(n/2), from one downwards.
double superellipsoid(const double* p) {
  const double east_west = p[3], north_south = p[4];
  const double section = std::pow(std::abs(p[0]), 2 / east_west) + std::pow(std::abs(p[1]), 2 / east_west);
  const double all = std::pow(section, east_west / north_south) + std::pow(std::abs(p[2]), 2 / north_south);
  return 1 - std::pow(all, north_south / 2);
}

}  // namespace isl::values
