#include "renderer/patterns/wave_patterns.h"

#include "renderer/patterns/waveform.h"
#include "renderer/values/noise.h"
#include "renderer/values/single_precision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace isl::render {
namespace {

struct WaveSource {
  Vec3 position{0};
  double frequency = 0;
};
using WaveSources = std::array<WaveSource, kMaxWaves>;

/// Directions of vector noise along x; frequencies from the generator behind the language's rand(), from POV-Ray's
/// seed.
const WaveSources& wave_sources() noexcept {
  static const WaveSources kSources = [] {
    WaveSources sources;
    std::uint32_t state = static_cast<std::uint32_t>(-560851967);
    for (int i = 0; i < kMaxWaves; ++i) {
      WaveSource& source = sources[static_cast<std::size_t>(i)];
      source.position = values::vector_noise(Vec3(i, 0, 0)).normalized();
      state = state * 1812433253u + 12345u;
      source.frequency = static_cast<double>(state >> 16 & 0x7FFFu) * 0.000030518509476 + 0.01;
    }
    return sources;
  }();
  return kSources;
}

}  // namespace

double waves(const Vec3& p, const scene::Pattern& pattern, int number_of_waves) noexcept {
  const WaveSources& sources = wave_sources();
  const double frequency = values::to_single(pattern.frequency), phase = values::to_single(pattern.phase);
  double sum = 0;
  for (int i = 0; i < number_of_waves; ++i) {
    const WaveSource& source = sources[static_cast<std::size_t>(i)];
    const double distance = (p - source.position).length();
    sum += cycloidal(distance * frequency * source.frequency + phase) / source.frequency;
  }
  return 0.2 * (2.5 + sum / number_of_waves);
}

double ripples(const Vec3& p, const scene::Pattern& pattern, int number_of_waves) noexcept {
  const WaveSources& sources = wave_sources();
  const double frequency = values::to_single(pattern.frequency), phase = values::to_single(pattern.phase);
  double sum = 0;
  for (int i = 0; i < number_of_waves; ++i)
    sum += cycloidal((p - sources[static_cast<std::size_t>(i)].position).length() * frequency + phase);
  return 0.5 * (1 + sum / number_of_waves);
}

}  // namespace isl::render
