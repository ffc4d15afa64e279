// Global settings of a scene.
#pragma once

#include "base/source_span.h"
#include "renderer/scene/colour.h"

#include <optional>
#include <string>

namespace isl::scene {

struct Settings {
  double language_version = 3.7;
  /// Nullopt: no gamma handling, pixel values are written unchanged. This is so in scenes older than version 3.7 that
  /// do not set it.
  std::optional<double> assumed_gamma;
  /// srgb: assumed_gamma 'srgb', a transfer curve rather than a power.
  bool assumed_gamma_srgb = false;
  Colour ambient_light{1, 1, 1};
  Colour background{0, 0, 0};
  int max_trace_level = 5;
  double adc_bailout = 1.0 / 255.0;
  Colour irid_wavelength{0.70, 0.52, 0.48};  ///< of red, green and blue light, for thin films
  int number_of_waves = 10;                  ///< number of wave centres of the patterns `waves` and `ripples`
  int noise_generator = 2;                   ///< number of POV-Ray's noise function that patterns use, 1 to 3
  double mm_per_unit = 10;
  std::string solver;     ///< "" if the scene does not set it
  std::string tolerance;  ///< as written: "0.05px" or "1e-4"; "" if the scene does not set it
  OriginId solver_origin{}, tolerance_origin{};
};

}  // namespace isl::scene
