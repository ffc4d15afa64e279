// Circular waves from a few sources on the unit sphere, as on water (Max 1981; Skinner).
#include "renderer/patterns/kinds/pattern_kind.h"
#include "renderer/patterns/kinds/waveform.h"
#include "renderer/values/noise.h"
#include "renderer/values/single_precision.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace isl::render {
namespace {

/// The greatest number of waves of a scene; at least 1.
constexpr int kMaxWaves = 100000;

struct WaveSource {
  Vec3 position{0};
  double frequency = 0;
};
using WaveSources = std::vector<WaveSource>;

/// The directions are vector noise at points along x; the frequencies come from the generator of the language's rand(),
/// with POV-Ray's seed.
WaveSources make_sources(int count) {
  WaveSources sources(static_cast<std::size_t>(count));
  auto state = static_cast<std::uint32_t>(-560851967);
  for (int i = 0; i < count; ++i) {
    WaveSource& source = sources[static_cast<std::size_t>(i)];
    source.position = values::vector_noise(Vec3(i, 0, 0)).normalized();
    state = state * 1812433253u + 12345u;
    source.frequency = static_cast<double>(state >> 16 & 0x7FFFu) * 0.000030518509476 + 0.01;
  }
  return sources;
}

/// The first `count` sources. They are computed once; few scenes use more than kUsual.
std::span<const WaveSource> wave_sources(int count) noexcept {
  constexpr int kUsual = 100;
  static const WaveSources kFew = make_sources(kUsual);
  if (count <= kUsual) return std::span(kFew).first(static_cast<std::size_t>(count));
  static const WaveSources kAll = make_sources(kMaxWaves);
  return std::span(kAll).first(static_cast<std::size_t>(std::min(count, kMaxWaves)));
}

/// Counts a step for every eight sources: together they take as long as another pattern.
bool take_steps(const PatternPoint& at, std::size_t sources) noexcept {
  return at.environment.steps().take(static_cast<std::uint64_t>(sources / 8));
}

/// 0.2 · (2.5 + mean of sin(2π(distance · frequency · fᵢ + phase)) / fᵢ) over the sources, each of its own frequency
/// fᵢ.
double waves_at(const PatternPoint& at) noexcept {
  const Vec3& p = at.point;
  const scene::Pattern& pattern = at.pattern;
  const std::span<const WaveSource> sources = wave_sources(at.world.number_of_waves);
  if (!take_steps(at, sources.size())) return 0;
  const double frequency = values::to_single(pattern.frequency), phase = values::to_single(pattern.phase);
  double sum = 0;
  for (const WaveSource& source : sources) {
    const double distance = (p - source.position).length();
    sum += cycloidal(distance * frequency * source.frequency + phase) / source.frequency;
  }
  return 0.2 * (2.5 + sum / static_cast<double>(sources.size()));
}

/// ½ · (1 + mean of sin(2π(distance · frequency + phase))).
double ripples_at(const PatternPoint& at) noexcept {
  const Vec3& p = at.point;
  const scene::Pattern& pattern = at.pattern;
  const std::span<const WaveSource> sources = wave_sources(at.world.number_of_waves);
  if (!take_steps(at, sources.size())) return 0;
  const double frequency = values::to_single(pattern.frequency), phase = values::to_single(pattern.phase);
  double sum = 0;
  for (const WaveSource& source : sources) sum += cycloidal((p - source.position).length() * frequency + phase);
  return 0.5 * (1 + sum / static_cast<double>(sources.size()));
}

/// Each source adds size · sin(2π(distance · frequency · fᵢ + phase)) / (distance · fᵢ · number of sources) times the
/// way from the source; fᵢ is 1 for ripples.
Vec3 bend(const PatternPoint& at, const Vec3& normal, double size, bool has_frequencies) noexcept {
  const std::span<const WaveSource> sources = wave_sources(at.world.number_of_waves);
  if (!take_steps(at, sources.size())) return normal;
  const double frequency = values::to_single(at.pattern.frequency), phase = values::to_single(at.pattern.phase);
  const double share = size / static_cast<double>(sources.size());
  Vec3 result = normal;
  for (const WaveSource& source : sources) {
    const Vec3 way = at.point - source.position;
    const double distance = way.length() > 0 ? way.length() : 1;
    const double own = has_frequencies ? source.frequency : 1;
    result += way * (share * cycloidal(distance * frequency * own + phase) / (distance * own));
  }
  return result;
}
Vec3 bend_by_ripples(const PatternPoint& at, const Vec3& normal, double size) noexcept {
  return bend(at, normal, size, false);
}
Vec3 bend_by_waves(const PatternPoint& at, const Vec3& normal, double size) noexcept {
  return bend(at, normal, size, true);
}

}  // namespace

constinit const PatternInfo pattern_kinds::ripples{.makes_bumps = true, .value = ripples_at, .bend = bend_by_ripples};
constinit const PatternInfo pattern_kinds::waves{.makes_bumps = true, .value = waves_at, .bend = bend_by_waves};

}  // namespace isl::render
