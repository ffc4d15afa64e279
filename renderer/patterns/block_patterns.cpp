#include "renderer/patterns/block_patterns.h"

#include <cmath>

namespace isl::render {
namespace {

/// What POV-Ray moves points by so that a plane through the lattice lies on one side.
constexpr double kSmall = 1e-10;

double fraction(double v) { return v - std::floor(v); }
bool is_odd(double whole) { return std::fmod(whole, 2) != 0; }

}  // namespace

double checker(const Vec3& p) noexcept {
  const double sum = std::floor(p.x + kSmall) + std::floor(p.y + kSmall) + std::floor(p.z + kSmall);
  return is_odd(sum) ? 1 : 0;
}

double brick(const Vec3& p, const scene::BrickOperands& operands) noexcept {
  const Vec3 q((p.x + kSmall) / operands.size.x, (p.y + kSmall) / operands.size.y, (p.z + kSmall) / operands.size.z);
  const Vec3 mortar(operands.mortar / operands.size.x, operands.mortar / operands.size.y,
                    operands.mortar / operands.size.z);
  if (fraction(q.y) <= mortar.y) return 0;
  const bool is_lower = fraction(q.y * 0.5) <= 0.5;
  if (fraction(q.x + (is_lower ? 0 : 0.5)) <= mortar.x) return 0;
  if (fraction(q.z + (is_lower ? 0.5 : 0)) <= mortar.z) return 0;
  return 1;
}

double cubic(const Vec3& p) noexcept {
  const Vec3 size(std::abs(p.x), std::abs(p.y), std::abs(p.z));
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  return p[axis] >= 0 ? axis : axis + 3;
}

double hexagon(const Vec3& /*p*/) noexcept { return 0; }
double square(const Vec3& /*p*/) noexcept { return 0; }
double triangular(const Vec3& /*p*/) noexcept { return 0; }

}  // namespace isl::render
