#include "renderer/patterns/kinds/turbulence.h"

#include <algorithm>

namespace isl::render {

using scene::Vec3;
using values::noise;
using values::NoiseGenerator;

double stretched_noise(const Vec3& p, NoiseGenerator generator) noexcept {
  const double value = noise(p, generator);
  return generator == NoiseGenerator::original ? value : std::clamp(2 * value - 0.5, 0.0, 1.0);
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

}  // namespace isl::render
