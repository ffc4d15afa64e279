// Output variables of the surface that a pixel's centre ray sees, unfiltered: an average of two depths or two numbers
// is on neither surface. A new one is a row of the table in surface_aovs.cpp.
#pragma once

#include "renderer/image/aov.h"
#include "renderer/rays/ray.h"
#include "renderer/rays/surface_point.h"

#include <span>

namespace isl::render {

/// The surface that the centre sample of a pixel hit.
struct SeenSurface {
  const Hit* hit = nullptr;             ///< never null
  const SurfacePoint* point = nullptr;  ///< null for a miss
  Rgb albedo{0};                        ///< linear
};

struct SurfaceAov {
  Aov aov;
  void (*fill)(const SeenSurface& seen, double* values);  ///< not called for a miss
};

[[nodiscard]] std::span<const SurfaceAov> surface_aovs();

/// How many camera rays a pixel got. The film counts them anyway.
[[nodiscard]] const Aov& samples_aov();

/// The noise that is left in a pixel's colour, as its own samples tell: the root of the variance, averaged over the
/// channels as a display gets them (0 to 1). 0 where a picture's samples are not evenly spread, or fewer than 8.
[[nodiscard]] const Aov& noise_aov();

/// How sure a pixel is: the worst Certainty of all its rays.
[[nodiscard]] const Aov& uncertified_aov();

}  // namespace isl::render
