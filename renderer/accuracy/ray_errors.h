// Errors of a solver, ray by ray and summed up, relative to the truth (accuracy/reference_hits.h).
//
// Errors are lengths along the ray. In pixels, they are divided by the width of the pixel's footprint at the
// reference's root. They are measured along the ray and not across the surface, because position, texture and shadow
// inherit that error; where a ray grazes, a small change of the field is a long way along the ray, in every method.
#pragma once

#include "renderer/accuracy/ray_measures.h"
#include "renderer/accuracy/reference_hits.h"

#include <cstdint>
#include <span>
#include <vector>

namespace isl::render {

enum class RayOutcome : std::uint8_t {
  background,     ///< nothing is there and nothing was found
  hit,            ///< a surface is there and one was found
  missed,         ///< a surface is there and nothing was found
  false_surface,  ///< a surface was found where nothing is
  undecided,      ///< the reference does not know
};

struct RayError {
  RayOutcome outcome = RayOutcome::background;
  double units = 0;   ///< scene units; 0 if there are not two roots to compare
  double pixels = 0;  ///< in pixels; likewise
};

/// `pixel_angle` as in TracerOptions.
[[nodiscard]] RayError error_of(const Ray& ray, const RayMeasure& found, const ReferenceHit& reference,
                                double pixel_angle);

/// Statistics over the rays where both found a surface; all lengths are 0 if there are none. The quantile q is the
/// least error that at least a share q of these rays does not exceed.
struct ErrorSummary {
  std::uint64_t hits = 0;
  double median_pixels = 0, p99_pixels = 0, worst_pixels = 0;
  double worst_units = 0;
  std::uint64_t beyond_pixel = 0;  ///< hits that are off by more than a pixel
  std::uint64_t missed = 0;
  std::uint64_t false_surfaces = 0;
  std::uint64_t undecided = 0;
  std::uint64_t holes = 0;  ///< missed rays with a surface at all eight pixels around, so that they show as holes
};

/// `errors` are those of a picture's centre rays, row by row, with `width` rays in a row.
[[nodiscard]] ErrorSummary summarise_errors(std::span<const RayError> errors, int width);

}  // namespace isl::render
