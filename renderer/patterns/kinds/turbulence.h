// The turbulence in the formulas of patterns and in the warp `turbulence`. Formulas by Perlin ("An Image Synthesizer",
// SIGGRAPH 1985); the constants were measured in POV-Ray.
#pragma once

#include "renderer/scene/pattern.h"
#include "renderer/values/noise.h"
#include "renderer/values/single_precision.h"

namespace isl::render {

/// A value of noise; those of generators 2 and 3 are stretched to the contrast of the first.
[[nodiscard]] double stretched(double value, values::NoiseGenerator generator) noexcept;

/// Σ omegaⁱ · noise(lambdaⁱ · p) with the noises 2 and 3 stretched.
[[nodiscard]] double turbulence_at(const scene::Vec3& p, const scene::Turbulence& turbulence,
                                   values::NoiseGenerator generator) noexcept;

[[nodiscard]] inline values::Octaves octaves_of(const scene::Turbulence& t) noexcept {
  return {values::to_single(t.lambda), values::to_single(t.omega), t.octaves};
}

}  // namespace isl::render
