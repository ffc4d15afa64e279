// The colour of highlights and reflections on metal.
//
// A metal's highlights and reflections have its own colour head-on and turn white at grazing angles. This is POV-Ray's
// model, from Hall's approximation of the Fresnel curve of a metal (R. Hall, Illumination and Color in Computer
// Generated Imagery, 1989): with
// x = angle / 90°, the whiteness is F(x) = 0.014567225/(x − 1.12)² − 0.011612903, which is 0 at x = 0 and 1 at x = 1.
#pragma once

#include "renderer/shading/material.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isl::render {

/// arccos(x)/(π/2) for 0 ≤ x ≤ 1, with the same bits on every machine; the C library picks its code by the processor.
/// Abramowitz and Stegun, Handbook of Mathematical Functions (1964), 4.4.46: off by at most 2.2e-8 radians (the book
/// says 2e-8, but its coefficients are rounded), far below a step of a picture's 16 bits.
[[nodiscard]] inline double right_angles(double x) {
  const double polynomial =
      1.5707963050 +
      x * (-0.2145988016 +
           x * (0.0889789874 + x * (-0.0501743046 +
                                    x * (0.0308918810 + x * (-0.0170881256 + x * (0.0066700901 - x * 0.0012624911))))));
  return std::sqrt(std::max(0.0, 1 - x)) * polynomial * (2 / std::numbers::pi);
}

/// The factor by which metal of this colour tints its reflections: 1 + amount (1 − F)(colour − 1). `cosine`: of the
/// angle between the normal and the light or the view, from -1 to 1; it is below 0 where bumps turn the normal away.
[[nodiscard]] inline Rgb metal_tint(double amount, double cosine, const Rgb& colour) {
  const double angle = right_angles(std::min(std::abs(cosine), 1.0));
  const double x = (cosine < 0 ? 2 - angle : angle) - 1.12;
  const double whiteness = std::clamp(0.014567225 / (x * x) - 0.011612903, 0.0, 1.0);
  return Rgb(1) + (colour - Rgb(1)) * (amount * (1 - whiteness));
}

}  // namespace isl::render
