// The colours of thin films, as in POV-Ray: interference changes what a surface throws back by a factor for each colour
// of light.
#pragma once

#include "renderer/patterns/kinds/turbulence.h"
#include "renderer/shading/lighting.h"

#include <cmath>
#include <numbers>

namespace isl::render {

/// The settings that all films of a scene share.
struct FilmLight {
  explicit FilmLight(const scene::Settings& settings)
      : wavelengths(rgb(settings.irid_wavelength)), noise(values::noise_generator_of(settings.noise_generator)) {}

  Rgb wavelengths;
  values::NoiseGenerator noise;
};

/// 1 + irid cos(2π h (|n·L| + |n·d|)/λ) for each colour's wavelength λ, where the thickness h varies with turbulence.
/// `out` and `in` are the cosines of the angles to the normal at which light leaves and falls in.
[[nodiscard]] inline Rgb film_factor(const scene::Finish& finish, const FilmLight& film, const Vec3& place, double out,
                                     double in) {
  double thickness = finish.irid_thickness;
  if (finish.irid_turbulence != 0) {
    constexpr int kOctaves = 5;
    const double noise = turbulence_at(place, {.octaves = kOctaves}, film.noise);
    thickness *= 1 + finish.irid_turbulence * (2 * noise - 1);
  }
  const double path = 2 * std::numbers::pi * thickness * (std::abs(out) + std::abs(in));
  Rgb factor(1);
  for (int i = 0; i < 3; ++i) factor[i] += finish.irid * std::cos(path / film.wavelengths[i]);
  return factor;
}

}  // namespace isl::render
