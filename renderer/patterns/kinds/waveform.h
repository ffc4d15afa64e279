// From a pattern's raw value to the one that chooses from a map: frequency, phase and the wave's form.
#pragma once

#include "renderer/scene/pattern.h"

namespace isl::render {

/// One turn of a sine for every whole number: in [−1, 1], odd.
[[nodiscard]] double cycloidal(double value) noexcept;
/// 0 at whole numbers, 1 half-way between.
[[nodiscard]] double triangle_wave(double value) noexcept;

/// fmod(value · frequency + phase, 1.00001), brought to be positive, through the wave. POV-Ray's modulus leaves room
/// above 1, so that 1 itself stays 1. A frequency of 0 leaves the value as it is.
[[nodiscard]] double in_wave(double value, const scene::Pattern& pattern) noexcept;

}  // namespace isl::render
