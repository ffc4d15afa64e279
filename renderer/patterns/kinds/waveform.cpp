#include "renderer/patterns/kinds/waveform.h"

#include "base/check.h"
#include "renderer/values/single_precision.h"

#include <cmath>
#include <numbers>

namespace isl::render {
namespace {

constexpr double kModulus = 1.00001;

/// The usual case needs no division.
double remainder(double value) { return std::abs(value) < kModulus ? value : std::fmod(value, kModulus); }

}  // namespace

double cycloidal(double value) noexcept {
  const double turn = std::abs(value);
  return std::copysign(1.0, value) * std::sin((turn - std::floor(turn)) * 2 * std::numbers::pi);
}

double triangle_wave(double value) noexcept {
  const double offset = value - std::floor(value);
  return offset >= 0.5 ? 2 * (1 - offset) : 2 * offset;
}

double in_wave(double value, const scene::Pattern& pattern) noexcept {
  const double frequency = values::to_single(pattern.frequency);
  if (frequency != 0) value = remainder(value * frequency + values::to_single(pattern.phase));
  if (value < 0) value -= std::floor(value);
  switch (pattern.wave) {
    case scene::Wave::ramp: return value;
    case scene::Wave::triangle: return triangle_wave(value);
    case scene::Wave::sine: return (1 + cycloidal(value)) * 0.5;
    case scene::Wave::scallop: return std::abs(cycloidal(value * 0.5));
    case scene::Wave::cubic: return value * value * (3 - 2 * value);
    case scene::Wave::poly: return std::pow(value, values::to_single(pattern.exponent));
  }
  ISL_CHECK(false, "wave {}", static_cast<int>(pattern.wave));
}

}  // namespace isl::render
