// Interiors: the medium inside a transparent object.
#pragma once

#include "renderer/scene/colour.h"

namespace isl::scene {

/// The defaults are POV-Ray's. Records can be compared byte by byte.
struct Interior {
  double ior = 1;
  double caustics = 0;
  double dispersion = 1;
  double dispersion_samples = 7;
  double fade_distance = 0;
  double fade_power = 0;
  Colour fade_colour{};
};

[[nodiscard]] inline const Interior& without_places(const Interior& interior) { return interior; }

}  // namespace isl::scene
