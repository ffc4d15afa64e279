// Maps a pattern's raw value to the one that chooses from a map: by frequency, phase and waveform.
#pragma once

#include "renderer/scene/pattern.h"

#include <cmath>

namespace isl::render {

/// A sine with period 1: in [−1, 1], odd.
[[nodiscard]] double cycloidal(double value) noexcept;
/// 0 at whole numbers, 1 half-way between.
[[nodiscard]] double triangle_wave(double value) noexcept;

/// in_wave() for any pattern.
[[nodiscard]] double in_any_wave(double value, const scene::Pattern& pattern) noexcept;

/// wave(fmod(value · frequency + phase, 1.00001)), with the modulus made positive. POV-Ray's modulus is above 1, so
/// that 1 itself stays 1. A frequency of 0 leaves the value unchanged.
[[nodiscard]] inline double in_wave(double value, const scene::Pattern& pattern) noexcept {
  const bool is_whole =
      pattern.frequency == 0 || (pattern.frequency == 1 && pattern.phase == 0 && std::abs(value) <= 1);
  if (!is_whole || pattern.wave != scene::Wave::ramp) return in_any_wave(value, pattern);
  return value < 0 ? value - std::floor(value) : value;
}

}  // namespace isl::render
