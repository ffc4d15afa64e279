#include "renderer/patterns/noise_patterns.h"

#include "renderer/patterns/waveform.h"

#include <algorithm>
#include <cmath>

namespace isl::render {

using values::noise;

double bozo(const Vec3& p, NoiseGenerator generator) noexcept { return noise(p, generator); }

double dents(const Vec3& p, NoiseGenerator generator) noexcept {
  const double value = noise(p, generator);
  return value * value * value;
}

double granite(const Vec3& p, NoiseGenerator generator) noexcept {
  constexpr int kOctaves = 6;
  constexpr double kScale = 4;
  const bool is_stretched = generator != NoiseGenerator::original;
  double sum = 0, frequency = 1;
  for (int i = 0; i < kOctaves; ++i, frequency *= 2) {
    const double value = noise(p * (kScale * frequency), generator);
    sum += (is_stretched ? std::min(std::abs(1 - 2 * value), 0.5) : std::abs(0.5 - value)) / frequency;
  }
  return sum;
}

double wrinkles(const Vec3& p, NoiseGenerator generator) noexcept {
  constexpr int kOctaves = 10;
  const bool is_stretched = generator != NoiseGenerator::original;
  double sum = 0, frequency = 1;
  for (int i = 0; i < kOctaves; ++i, frequency *= 2) {
    const double value = noise(p * frequency, generator);
    sum += (is_stretched ? std::clamp(2 * value - 0.5, 0.0, 1.0) : value) / frequency;
  }
  return sum / 2;
}

double turbulence_at(const Vec3& p, const scene::Turbulence& turbulence, NoiseGenerator generator) noexcept {
  return values::turbulence(p, octaves_of(turbulence), generator);
}

double agate(const Vec3& p, const scene::Turbulence& turbulence, double strength, NoiseGenerator generator) noexcept {
  const double wave = cycloidal(1.3 * strength * turbulence_at(p, turbulence, generator) + 1.1 * p.z);
  return std::pow(0.5 * (wave + 1), 0.77);
}

double marble(const Vec3& p, const scene::Turbulence& turbulence, NoiseGenerator generator) noexcept {
  if (turbulence.amount.x == 0) return p.x;
  return p.x + turbulence.amount.x * turbulence_at(p, turbulence, generator);
}

double wood(const Vec3& p, const scene::Turbulence& turbulence) noexcept {
  if (turbulence.amount == Vec3(0)) return std::sqrt(p.x * p.x + p.y * p.y);
  const Vec3 moved = p + values::vector_turbulence(p, octaves_of(turbulence));
  const double x = p.x + cycloidal(moved.x * turbulence.amount.x);
  const double y = p.y + cycloidal(moved.y * turbulence.amount.y);
  return std::sqrt(x * x + y * y);
}

}  // namespace isl::render
