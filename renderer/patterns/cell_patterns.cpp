#include "renderer/patterns/cell_patterns.h"

#include "renderer/patterns/random_cubes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isl::render {
namespace {

/// The feature point.
Vec3 point_in(const Cube& cube) noexcept {
  const double* const random = random_numbers(cube);
  return {cube.x + random[0], cube.y + random[1], cube.z + random[2]};
}

/// Distances |d|ⁿ, of points `offset` apart in a fourth dimension, that compare as those of the metric do.
class Metric {
 public:
  Metric(double exponent, double offset)
      : exponent_(exponent),
        offset_(exponent == 2   ? offset * offset
                : exponent == 1 ? offset
                                : std::pow(offset, exponent)) {}

  [[nodiscard]] double comparable(const Vec3& d) const noexcept {
    if (exponent_ == 2) return d.dot(d) + offset_;
    if (exponent_ == 1) return std::abs(d.x) + std::abs(d.y) + std::abs(d.z) + offset_;
    return std::pow(std::abs(d.x), exponent_) + std::pow(std::abs(d.y), exponent_) +
           std::pow(std::abs(d.z), exponent_) + offset_;
  }
  [[nodiscard]] double distance(double comparable) const noexcept {
    if (exponent_ == 2) return std::sqrt(comparable);
    if (exponent_ == 1) return comparable;
    return std::pow(comparable, 1 / exponent_);
  }

 private:
  double exponent_;
  double offset_;
};

}  // namespace

double cells(const Vec3& p) noexcept { return *random_numbers(cube_of(p)); }

double crackle(const Vec3& p, const scene::CrackleOperands& operands, values::NoiseGenerator generator) noexcept {
  const Metric metric(operands.metric, operands.offset);
  const Cube home = cube_of(p);
  constexpr double kFar = std::numeric_limits<double>::max();
  double nearest[3] = {kFar, kFar, kFar};
  Vec3 nearest_point(0);
  for (int dx = -2; dx <= 2; ++dx) {
    for (int dy = -2; dy <= 2; ++dy) {
      for (int dz = -2; dz <= 2; ++dz) {
        // The corners of the block of 5³ are too far away to matter.
        if (std::abs(dx) + std::abs(dy) + std::abs(dz) > 4) continue;
        const Vec3 point = point_in({home.x + dx, home.y + dy, home.z + dz});
        const double d = metric.comparable(p - point);
        if (d < nearest[0]) {
          nearest[2] = nearest[1];
          nearest[1] = nearest[0];
          nearest[0] = d;
          nearest_point = point;
        } else if (d < nearest[1]) {
          nearest[2] = nearest[1];
          nearest[1] = d;
        } else if (d < nearest[2]) {
          nearest[2] = d;
        }
      }
    }
  }
  if (operands.is_solid) return values::noise(nearest_point, generator);
  const double sum = operands.form.x * metric.distance(nearest[0]) + operands.form.y * metric.distance(nearest[1]) +
                     operands.form.z * metric.distance(nearest[2]);
  return std::clamp(sum, 0.0, 1.0);
}

}  // namespace isl::render
