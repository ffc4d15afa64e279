// Circular waves from a few sources on the unit sphere, as on water (Max 1981; Skinner).
#pragma once

#include "renderer/scene/pattern.h"

namespace isl::render {

using scene::Vec3;

/// The most that a scene can ask for; at least 1.
inline constexpr int kMaxWaves = 100000;

/// 0.2 · (2.5 + mean of sin(2π(distance · frequency · fᵢ + phase)) / fᵢ) over the sources, each of its own frequency
/// fᵢ.
[[nodiscard]] double waves(const Vec3& p, const scene::Pattern& pattern, int number_of_waves) noexcept;
/// ½ · (1 + mean of sin(2π(distance · frequency + phase))).
[[nodiscard]] double ripples(const Vec3& p, const scene::Pattern& pattern, int number_of_waves) noexcept;

}  // namespace isl::render
