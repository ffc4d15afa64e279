#include "renderer/values/surfaces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isl::values {
namespace {

/// Distance from the middle of a cross-section in the p-norm with p = 2/shape: the maximum norm for shape 0, the
/// Euclidean norm for 1.
double from_middle(double a, double b, double shape) {
  a = std::abs(a);
  b = std::abs(b);
  if (shape == 0) return std::max(a, b);
  return std::pow(std::pow(a, 2 / shape) + std::pow(b, 2 / shape), shape / 2);
}

}  // namespace

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

/// Distance to the box in which the centres of the corners' spheres lie, minus their radius; that distance is zero
/// inside the box. POV-Ray subtracts another millionth, so that a box without rounding has an inside.
double rounded_box(const double* p) {
  constexpr double kInside = 1e-6;
  double outside[3];
  for (int i = 0; i < 3; ++i) outside[i] = std::max(std::abs(p[i]) - (p[4 + i] - p[3]), 0.0);
  return radius(outside) - p[3] - kInside;
}

/// Barr's superellipsoid: 1 − ((|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n))^(n/2).
double superellipsoid(const double* p) {
  const double east_west = p[3], north_south = p[4];
  const double section = std::pow(std::abs(p[0]), 2 / east_west) + std::pow(std::abs(p[1]), 2 / east_west);
  const double all = std::pow(section, east_west / north_south) + std::pow(std::abs(p[2]), 2 / north_south);
  return 1 - std::pow(all, north_south / 2);
}

/// In the half-plane through the axis, the tube's middle is where the angle about y, plus the height's share, is half a
/// turn. If that is far away, the distance to the opposite tube bounds the value.
double helix_1(const double* p) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double count = p[3], period = p[4], minor = p[5], major = p[6], stretch = p[7], shape = p[8];
  const double rotation = p[9] * std::numbers::pi / 180;
  const double from_axis = std::sqrt(p[0] * p[0] + p[2] * p[2]);
  double phase = std::fmod(count * (std::atan2(p[2], p[0]) + p[1] * period), kTurn);
  if (phase < 0) phase += kTurn;
  const double along = (phase - std::numbers::pi) / (period * count * stretch), across = from_axis - major;
  const double c = std::cos(rotation), s = std::sin(rotation);
  return std::min(from_middle(across * c - along * s, across * s + along * c, shape), from_axis + major) - minor;
}

/// All horizontal sections have the same shape, moved about the axis and turned with it.
double helix_2(const double* p) {
  const double minor = p[5], major = p[6], shape = p[8], angle = p[1] * p[4];
  const double c = std::cos(angle), s = std::sin(angle);
  const double x = p[0] - major * c, z = p[2] - major * s;
  return from_middle(x * c + z * s, z * c - x * s, shape) - minor;
}

}  // namespace isl::values
