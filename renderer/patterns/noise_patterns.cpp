#include "renderer/patterns/noise_patterns.h"

#include "renderer/patterns/waveform.h"

#include <algorithm>
#include <cmath>

namespace isl::render {

using values::noise;

namespace {

/// The noises 2 and 3 stretched to the contrast of the first.
double stretched_noise(const Vec3& p, NoiseGenerator generator) {
  const double value = noise(p, generator);
  return generator == NoiseGenerator::original ? value : std::clamp(2 * value - 0.5, 0.0, 1.0);
}

}  // namespace

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
  double sum = 0, frequency = 1;
  for (int i = 0; i < kOctaves; ++i, frequency *= 2) sum += stretched_noise(p * frequency, generator) / frequency;
  return sum / 2;
}

double turbulence_at(const Vec3& p, const scene::Turbulence& turbulence, NoiseGenerator generator) noexcept {
  const values::Octaves octaves = octaves_of(turbulence);
  double sum = stretched_noise(p, generator), scale = 1, weight = 1;
  for (int i = 1; i < octaves.count; ++i) {
    scale *= octaves.lambda;
    weight *= octaves.omega;
    sum += weight * (generator == NoiseGenerator::original ? noise(p * scale, generator)
                                                           : 2 * noise(p * scale, generator) - 0.5);
  }
  return sum;
}

double agate(const Vec3& p, const scene::Turbulence& turbulence, double strength, NoiseGenerator generator) noexcept {
  const double wave =
      cycloidal(1.3 * values::to_single(strength) * turbulence_at(p, turbulence, generator) + 1.1 * p.z);
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
