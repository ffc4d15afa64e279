// Patterns made of noise: clouds and stones. Formulas by Perlin ("An Image Synthesizer", SIGGRAPH 1985: turbulence,
// marble, wrinkles) and Skinner; constants as POV-Ray's program answers.
#pragma once

#include "renderer/scene/pattern.h"
#include "renderer/values/noise.h"
#include "renderer/values/single_precision.h"

namespace isl::render {

using scene::Vec3;
using values::NoiseGenerator;

/// noise(p): `bozo`, `spotted` and `bumps` are the same.
[[nodiscard]] double bozo(const Vec3& p, NoiseGenerator generator) noexcept;
/// noise(p)³.
[[nodiscard]] double dents(const Vec3& p, NoiseGenerator generator) noexcept;
/// Σ |½ − noise(4 · 2ⁱ · p)| / 2ⁱ, six octaves; the noises 2 and 3 are stretched so that they look like the first.
[[nodiscard]] double granite(const Vec3& p, NoiseGenerator generator) noexcept;
/// ½ Σ noise(2ⁱ · p) / 2ⁱ, ten octaves.
[[nodiscard]] double wrinkles(const Vec3& p, NoiseGenerator generator) noexcept;
/// (½ + ½ sin 2π(1.3 · strength · turbulence(p) + 1.1 · p.z))^0.77.
[[nodiscard]] double agate(const Vec3& p, const scene::Turbulence& turbulence, double strength,
                           NoiseGenerator generator) noexcept;
/// p.x + amount.x · turbulence(p).
[[nodiscard]] double marble(const Vec3& p, const scene::Turbulence& turbulence, NoiseGenerator generator) noexcept;
/// The distance from the z axis, its point pushed about by sines of the turbulence.
[[nodiscard]] double wood(const Vec3& p, const scene::Turbulence& turbulence) noexcept;

/// Σ omegaⁱ · noise(lambdaⁱ · p) with the noises 2 and 3 stretched: what patterns take that use the turbulence
/// themselves.
[[nodiscard]] double turbulence_at(const Vec3& p, const scene::Turbulence& turbulence,
                                   NoiseGenerator generator) noexcept;
[[nodiscard]] inline values::Octaves octaves_of(const scene::Turbulence& t) noexcept {
  return {values::to_single(t.lambda), values::to_single(t.omega), t.octaves};
}

}  // namespace isl::render
