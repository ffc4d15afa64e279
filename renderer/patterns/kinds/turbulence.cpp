#include "renderer/patterns/kinds/turbulence.h"

#include <algorithm>

namespace isl::render {

using scene::Vec3;
using values::NoiseGenerator;

double stretched(double value, NoiseGenerator generator) noexcept {
  return generator == NoiseGenerator::original ? value : std::clamp(2 * value - 0.5, 0.0, 1.0);
}

double turbulence_at(const Vec3& p, const scene::Turbulence& turbulence, NoiseGenerator generator) noexcept {
  const values::Octaves octaves = octaves_of(turbulence);
  double sum = 0, weight = 1;
  bool is_first = true;
  values::for_octaves(p, octaves, generator, [&](double value) {
    if (generator != NoiseGenerator::original) {
      value = 2 * value - 0.5;
      // Only the first octave is kept within its range.
      if (is_first) value = std::clamp(value, 0.0, 1.0);
    }
    is_first = false;
    sum += weight * value;
    weight *= octaves.omega;
  });
  return sum;
}

}  // namespace isl::render
