// Output variables that are measured by tracing the pixels' centre rays again, each by itself, without the shading and
// shadows behind it (accuracy/measured_layers.h). A new one is a row of the table in measured_aovs.cpp.
#pragma once

#include "renderer/accuracy/ray_errors.h"
#include "renderer/image/aov.h"

#include <span>

namespace isl::render {

struct MeasuredAov {
  Aov aov;
  bool needs_reference = false;  ///< the rays are traced by the reference, too
  void (*fill)(const RayMeasure& found, const RayError& error, double* values) = nullptr;
};

[[nodiscard]] std::span<const MeasuredAov> measured_aovs();

}  // namespace isl::render
