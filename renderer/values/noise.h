// Noise: smooth random functions of space. They are POV-Ray's three to the last digit (docs/decisions.md tells how they
// were found).
//
// The older two are lattice noise as in Skinner and Kolb's Rayshade: every lattice point owns a value and a slope,
// picked from a table of random numbers by a hash of its coordinates; in between, the eight corners' linear functions
// are blended with s = t²(3 − 2t). The third is Perlin's gradient noise of 1985. Tables are made by their published
// generators when noise is first used.
#pragma once

#include "renderer/scene/transform.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace isl::values {

/// `noise_generator` 1 to 3 of the language.
enum class NoiseGenerator : std::uint8_t {
  original = 1,         ///< clipped to [0, 1] where the sum of slopes leaves it
  range_corrected = 2,  ///< the same, scaled into [0, 1]
  perlin = 3,           ///< about 0.5, flatter at the lattice points
};

/// The generator of a number by the lowest two bits of its integer part, as in POV-Ray; 0 is the original.
[[nodiscard]] NoiseGenerator noise_generator_of(double number) noexcept;

/// The value is in [0, 1]. Coordinates beyond ±2³⁰ have no detail left; NaN gives a number all the same.
[[nodiscard]] double noise(const scene::Vec3& p, NoiseGenerator generator) noexcept;

/// Three noises at once, each about 0 and within ±1 or little more. They are the same for all generators.
[[nodiscard]] scene::Vec3 vector_noise(const scene::Vec3& p) noexcept;

/// Octaves of noise: each next one is finer by `lambda` and weaker by `omega`.
struct Octaves {
  double lambda = 2;
  double omega = 0.5;
  int count = 6;  ///< at least 1
};

/// values[i] = noise(scale · lambdaⁱ · p), faster than one by one.
void noise_octaves(const scene::Vec3& p, double scale, double lambda, NoiseGenerator generator,
                   std::span<double> values) noexcept;

/// Calls add(noise(lambdaⁱ · p)) with i from 0 to count − 1.
template <class Add>
void for_octaves(const scene::Vec3& p, const Octaves& octaves, NoiseGenerator generator, Add add) {
  std::array<double, 8> values;
  double scale = 1;
  for (auto left = static_cast<std::size_t>(octaves.count); left > 0;) {
    const std::span<double> some = std::span(values).first(std::min(left, values.size()));
    noise_octaves(p, scale, octaves.lambda, generator, some);
    for (const double value : some) {
      add(value);
      scale *= octaves.lambda;
    }
    left -= some.size();
  }
}

/// Σ omegaⁱ · vector_noise(lambdaⁱ · p), i from 0.
[[nodiscard]] scene::Vec3 vector_turbulence(const scene::Vec3& p, const Octaves& octaves) noexcept;
/// Σ omegaⁱ · noise(lambdaⁱ · p).
[[nodiscard]] double turbulence(const scene::Vec3& p, const Octaves& octaves, NoiseGenerator generator) noexcept;

}  // namespace isl::values
