// How far below its bound the rounding of a sum usually is. A root is polished until its value is that small.
#pragma once

namespace isl::render {

/// Rounding moves a sum by no less than this share of the bound of its rounding errors: of the n + 16 half units in the
/// last place that such a bound allows, one or two occur in the mean, and n is seldom above 100. A value below this
/// share of its bound is lost in its rounding.
inline constexpr double kRoundingOfNoise = 1.0 / 64;

}  // namespace isl::render
