// Patterns made of noise: clouds and stones. Formulas by Perlin ("An Image Synthesizer", SIGGRAPH 1985: marble,
// wrinkles) and Skinner; the constants were measured in POV-Ray.
#include "renderer/patterns/kinds/pattern_kind.h"
#include "renderer/patterns/kinds/turbulence.h"
#include "renderer/patterns/kinds/waveform.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isl::render {
namespace {

using scene::OperandField;
using values::noise;
using values::NoiseGenerator;

/// noise(p).
double plain_noise(const PatternPoint& at) noexcept { return noise(at.point, at.noise_generator()); }

/// noise(p)³.
double dents_at(const PatternPoint& at) noexcept {
  const double value = plain_noise(at);
  return value * value * value;
}

/// Σ |½ − noise(4 · 2ⁱ · p)| / 2ⁱ, six octaves; the noises 2 and 3 are stretched so that they look like the first.
double granite_at(const PatternPoint& at) noexcept {
  constexpr double kScale = 4;
  const NoiseGenerator generator = at.noise_generator();
  const bool is_stretched = generator != NoiseGenerator::original;
  std::array<double, 6> octaves;
  values::noise_octaves(at.point, kScale, 2, generator, octaves);
  double sum = 0, frequency = 1;
  for (const double value : octaves) {
    sum += (is_stretched ? std::min(std::abs(1 - 2 * value), 0.5) : std::abs(0.5 - value)) / frequency;
    frequency *= 2;
  }
  return sum;
}

/// ½ Σ noise(2ⁱ · p) / 2ⁱ, ten octaves.
double wrinkles_at(const PatternPoint& at) noexcept {
  const NoiseGenerator generator = at.noise_generator();
  std::array<double, 10> octaves;
  values::noise_octaves(at.point, 1, 2, generator, octaves);
  double sum = 0, frequency = 1;
  for (const double value : octaves) {
    sum += stretched(value, generator) / frequency;
    frequency *= 2;
  }
  return sum / 2;
}

/// Towards a vector noise.
Vec3 bend_by_bumps(const PatternPoint& at, const Vec3& normal, double size) noexcept {
  return normal + values::vector_noise(at.point) * size;
}
Vec3 bend_by_dents(const PatternPoint& at, const Vec3& normal, double size) noexcept {
  return normal + values::vector_noise(at.point) * (size * dents_at(at));
}
/// Towards Σ |vector noise(2ⁱ · p)| / 2ⁱ, ten octaves, each coordinate's size.
Vec3 bend_by_wrinkles(const PatternPoint& at, const Vec3& normal, double size) noexcept {
  constexpr int kOctaves = 10;
  Vec3 sum(0);
  double frequency = 1;
  for (int i = 0; i < kOctaves; ++i, frequency *= 2) {
    const Vec3 push = values::vector_noise(at.point * frequency);
    sum += Vec3(std::abs(push.x), std::abs(push.y), std::abs(push.z)) / frequency;
  }
  return normal + sum * size;
}

struct Agate {
  double turbulence = 1;
};
constexpr OperandField kAgate[] = {scene::modifier<&Agate::turbulence>("agate_turb")};

/// (½ + ½ sin 2π(1.3 · strength · turbulence(p) + 1.1 · p.z))^0.77.
double agate_at(const PatternPoint& at) noexcept {
  const double strength = values::to_single(at.operands<Agate>().turbulence);
  const double turbulence = turbulence_at(at.point, at.pattern.turbulence, at.noise_generator());
  const double wave = cycloidal(1.3 * strength * turbulence + 1.1 * at.point.z);
  return std::pow(0.5 * (wave + 1), 0.77);
}

/// p.x + amount.x · turbulence(p).
double marble_at(const PatternPoint& at) noexcept {
  const scene::Turbulence& turbulence = at.pattern.turbulence;
  if (turbulence.amount.x == 0) return at.point.x;
  return at.point.x + turbulence.amount.x * turbulence_at(at.point, turbulence, at.noise_generator());
}

/// The distance from the z axis of the point, displaced by sines of the turbulence.
double wood_at(const PatternPoint& at) noexcept {
  const Vec3& p = at.point;
  const scene::Turbulence& turbulence = at.pattern.turbulence;
  if (turbulence.amount == Vec3(0)) return std::sqrt(p.x * p.x + p.y * p.y);
  const Vec3 moved = p + values::vector_turbulence(p, octaves_of(turbulence));
  const double x = p.x + cycloidal(moved.x * turbulence.amount.x);
  const double y = p.y + cycloidal(moved.y * turbulence.amount.y);
  return std::sqrt(x * x + y * y);
}

// The values of these maps, and of those of other kinds, were read off POV-Ray 3.7's pigments without a map (`frequency
// 1e-9 phase v` shows the map at v).
constexpr PatternColour kAgateColours[] = {{0, 1, 1, 1},         {0.5, 0.95, 0.75, 0.5}, {0.5, 0.9, 0.7, 0.5},
                                           {0.6, 0.9, 0.7, 0.4}, {0.6, 1, 0.7, 0.4},     {1, 0.6, 0.3, 0}};
constexpr PatternColour kBozoColours[] = {{0, 1, 1, 1},   {0.4, 1, 1, 1}, {0.4, 0, 1, 0}, {0.6, 0, 1, 0},
                                          {0.6, 0, 0, 1}, {0.8, 0, 0, 1}, {0.8, 1, 0, 0}, {1, 1, 0, 0}};
constexpr PatternColour kMarbleColours[] = {{0, 0.9, 0.8, 0.8}, {0.9, 0.9, 0.08, 0.08}, {0.9, 0, 0, 0}, {1, 0, 0, 0}};
constexpr PatternColour kWoodColours[] = {
    {0, 0.666, 0.312, 0.2}, {0.6, 0.666, 0.312, 0.2}, {0.6, 0.4, 0.1333, 0.066}, {1, 0.4, 0.1333, 0.066}};

}  // namespace

constinit const PatternInfo pattern_kinds::agate{
    .colours = kAgateColours, .operands = operands_of<Agate, kAgate>, .value = agate_at};
constinit const PatternInfo pattern_kinds::bozo{.colours = kBozoColours, .value = plain_noise};
constinit const PatternInfo pattern_kinds::bumps{.makes_bumps = true, .value = plain_noise, .bend = bend_by_bumps};
constinit const PatternInfo pattern_kinds::dents{.makes_bumps = true, .value = dents_at, .bend = bend_by_dents};
constinit const PatternInfo pattern_kinds::granite{.value = granite_at};
constinit const PatternInfo pattern_kinds::marble{
    .wave = scene::Wave::triangle, .colours = kMarbleColours, .uses_turbulence_itself = true, .value = marble_at};
constinit const PatternInfo pattern_kinds::spotted{.value = plain_noise};
constinit const PatternInfo pattern_kinds::wood{
    .wave = scene::Wave::triangle, .colours = kWoodColours, .uses_turbulence_itself = true, .value = wood_at};
constinit const PatternInfo pattern_kinds::wrinkles{
    .makes_bumps = true, .value = wrinkles_at, .bend = bend_by_wrinkles};

}  // namespace isl::render
