#include "renderer/patterns/round_patterns.h"

#include "renderer/patterns/waveform.h"
#include "renderer/values/single_precision.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isl::render {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

double fading(double distance) { return 1 - std::min(distance, 1.0); }

/// About the z axis from −y towards x, in [0, 2π).
double angle_about_z(const Vec3& p) {
  const double angle = std::atan2(p.x, -p.y);
  return angle < 0 ? angle + kTurn : angle;
}

double radius_about_z(const Vec3& p) { return std::sqrt(p.x * p.x + p.y * p.y); }

}  // namespace

double onion(const Vec3& p) noexcept { return std::sqrt(p.dot(p)); }
double spherical(const Vec3& p) noexcept { return fading(std::sqrt(p.dot(p))); }
double cylindrical(const Vec3& p) noexcept { return fading(std::sqrt(p.x * p.x + p.z * p.z)); }
double boxed(const Vec3& p) noexcept { return fading(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)})); }
double planar(const Vec3& p) noexcept { return fading(std::abs(p.y)); }

double radial(const Vec3& p) noexcept {
  constexpr double kAxisRadius = 0.001;
  if (std::abs(p.x) < kAxisRadius && std::abs(p.z) < kAxisRadius) return 0.25;
  return 0.25 + (std::atan2(p.x, p.z) + std::numbers::pi) / kTurn;
}

double gradient(const Vec3& p, const Vec3& direction) noexcept { return p.dot(direction); }

double leopard(const Vec3& p) noexcept {
  const double mean = (std::sin(p.x) + std::sin(p.y) + std::sin(p.z)) / 3;
  return mean * mean;
}

double quilted(const Vec3& p, const scene::QuiltedOperands& operands) noexcept {
  const Vec3 offset(p.x - std::floor(p.x) - 0.5, p.y - std::floor(p.y) - 0.5, p.z - std::floor(p.z) - 0.5);
  const double t = std::sqrt(offset.dot(offset)), s = 1 - t;
  const double swelling = 3 * t * s * s * values::to_single(operands.control0) +
                          3 * t * t * s * values::to_single(operands.control1) + t * t * t;
  // 1/√¾ as POV-Ray writes it: the corner of the cube comes to 1 for a swelling of 1.
  constexpr double kScale = 1.154700538 / 3;
  return (std::abs(offset.x) + std::abs(offset.y) + std::abs(offset.z)) * swelling * kScale;
}

double spiral1(const Vec3& p, int arms, double turbulence) noexcept {
  return p.z + radius_about_z(p) + arms * angle_about_z(p) / kTurn + turbulence;
}

double spiral2(const Vec3& p, int arms, double turbulence) noexcept {
  return triangle_wave(radius_about_z(p)) + triangle_wave(spiral1(p, arms, turbulence));
}

}  // namespace isl::render
