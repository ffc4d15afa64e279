#include "renderer/values/polynomials.h"

#include <algorithm>

namespace isl::values {
namespace {

constexpr double kClip = 10;

/// The point, with the squares that most formulas need.
struct Point {
  explicit Point(const double* p) : x(p[0]), y(p[1]), z(p[2]), x2(x * x), y2(y * y), z2(z * z) {}
  double x, y, z, x2, y2, z2;
};

double field(const double* p, double value) { return std::clamp(p[3] * value, -kClip, kClip); }

double cube(double v) { return v * v * v; }

}  // namespace

double crossed_trough(const double* p) {
  const Point q(p);
  return field(p, q.x2 * q.z2 - q.y);
}

double cubic_saddle(const double* p) {
  const Point q(p);
  return field(p, q.y * q.y2 - q.x * q.x2 + q.z);
}

double cushion(const double* p) {
  const Point q(p);
  const double dome = q.y2 - q.z;
  return field(p,
               q.z2 * (q.x2 - q.y2 - q.z2 + 2 * q.z - 1) + q.y2 + q.x2 - 2 * q.x2 * q.y2 - q.x2 * q.x2 - dome * dome);
}

double devils_curve(const double* p) {
  const Point q(p);
  const double across = q.x2 + q.z2;
  return field(p, q.y2 * (q.y2 - 0.25) - across * across + 0.36 * q.x2);
}

double glob(const double* p) {
  const Point q(p);
  return field(p, q.x2 * q.x2 * (q.x + 1) / 2 - q.y2 - q.z2);
}

double heart(const double* p) {
  const Point q(p);
  const double body = 2 * q.x2 + q.y2 + q.z2 - 1;
  return field(p, q.z * q.z2 * (0.1 * q.x2 + q.y2) - cube(body));
}

double kummer_surface_1(const double* p) {
  const Point q(p);
  return field(
      p, q.x2 + q.y2 + q.z2 + q.x2 * q.y2 + q.y2 * q.z2 + q.z2 * q.x2 - q.x2 * q.x2 - q.y2 * q.y2 - q.z2 * q.z2 - 1);
}

double klein_bottle(const double* p) {
  const Point q(p);
  const double r2 = q.x2 + q.y2 + q.z2, plus = r2 + 2 * q.y - 1, minus = r2 - 2 * q.y - 1;
  return field(p, -(plus * (minus * minus - 8 * q.z2) + 16 * q.x * q.z * minus));
}

double lemniscate_of_gerono(const double* p) {
  const Point q(p);
  return field(p, q.x2 * (1 - q.x2) - q.y2 - q.z2);
}

double mitre(const double* p) {
  const Point q(p);
  return field(p, q.y2 * (1 - q.y2 - q.z2) - 4 * q.x2 * (q.x2 + q.y2 + q.z2));
}

double nodal_cubic(const double* p) {
  const Point q(p);
  return field(p, 6 * q.y * q.z - q.y * q.y2 - q.z * q.z2);
}

double paraboloid(const double* p) {
  const Point q(p);
  return field(p, q.y - q.x2 - q.z2);
}

double pillow(const double* p) {
  const Point q(p);
  return field(p, q.x2 * (q.x2 - 1) + q.y2 * (q.y2 - 1) + q.z2 * (q.z2 - 1));
}

double piriform(const double* p) {
  const Point q(p);
  return field(p, q.x * q.x2 * (q.x - 1) + q.y2 + q.z2);
}

double quartic_paraboloid(const double* p) {
  const Point q(p);
  return field(p, q.y - q.x2 * q.x2 - q.z2 * q.z2);
}

double quartic_saddle(const double* p) {
  const Point q(p);
  return field(p, q.z2 * q.z2 + q.y - q.x2 * q.x2);
}

double steiners_roman(const double* p) {
  const Point q(p);
  return field(p, -(q.x2 * q.y2 + q.y2 * q.z2 + q.z2 * q.x2 + q.x * q.y * q.z));
}

double torus_gumdrop(const double* p) {
  const Point q(p);
  const double yz = q.y2 + q.z2;
  return field(p, 20 * (q.x2 + yz) - 4 * (q.x2 * q.x2 + yz * yz) - 17 * (q.x2 * yz + 1));
}

double umbrella(const double* p) {
  const Point q(p);
  return field(p, q.y * q.z2 - q.x2);
}

double hunt_surface(const double* p) {
  const Point q(p);
  const double ball = q.x2 + q.y2 + q.z2 - 13, ring = 3 * q.x2 + q.y2 - 4 * q.z2 - 12;
  return field(p, -(4 * cube(ball) + 27 * ring * ring));
}

}  // namespace isl::values
