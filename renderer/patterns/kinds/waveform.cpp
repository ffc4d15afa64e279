#include "renderer/patterns/kinds/waveform.h"

#include "base/check.h"
#include "renderer/values/single_precision.h"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace isl::render {
namespace {

constexpr double kModulus = 1.00001;

/// fmod(value, kModulus), to the last bit. The modulus has a part of 30 bits and a rest of 23, whose multiples by a
/// quotient of up to 2²³ are exact, and so are both differences: the first by Sterbenz's lemma, the second because any
/// remainder is a double.
double remainder(double value) {
  constexpr auto kHigh = static_cast<double>(static_cast<std::int64_t>(kModulus * 0x1p29)) * 0x1p-29;
  constexpr double kLow = kModulus - kHigh, kMostSize = 0x1p22;
  static_assert(kHigh + kLow == kModulus && kLow * 0x1p52 < 0x1p23);
  const double size = std::abs(value);
  if (size < kModulus) return value;
  if (!(size < kMostSize)) return std::fmod(value, kModulus);
  const auto rest_of = [size](double quotient) { return (size - quotient * kHigh) - quotient * kLow; };
  const auto quotient = static_cast<double>(static_cast<std::int32_t>(size * (1 / kModulus)));
  double rest = rest_of(quotient);
  // The product may round up to the next whole number, or down from it.
  if (rest < 0) rest = rest_of(quotient - 1);
  if (rest >= kModulus) rest = rest_of(quotient + 1);
  return std::copysign(rest, value);
}

}  // namespace

double cycloidal(double value) noexcept {
  const double turn = std::abs(value);
  return std::copysign(1.0, value) * std::sin((turn - std::floor(turn)) * 2 * std::numbers::pi);
}

double triangle_wave(double value) noexcept {
  const double offset = value - std::floor(value);
  return offset >= 0.5 ? 2 * (1 - offset) : 2 * offset;
}

double in_any_wave(double value, const scene::Pattern& pattern) noexcept {
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
