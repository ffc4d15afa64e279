// How far what a solver found is off, ray by ray and in numbers for all: against a reference taken for the truth
// (accuracy/reference_check.h says how far it can be).
//
// Errors are lengths along the ray. In pixels: over the width of the pixel's footprint at the reference's root. Along
// the ray and not across the surface, because that is what position, texture and shadow inherit; where a ray grazes, a
// small change of the field is a long way along the ray, in every method.
#pragma once

#include "renderer/accuracy/ray_measures.h"

#include <cstdint>
#include <span>
#include <vector>

namespace isl::render {

enum class RayOutcome : std::uint8_t {
  background,     ///< nothing is there and nothing was found
  hit,            ///< a surface is there and one was found
  missed,         ///< a surface is there and nothing was found
  false_surface,  ///< a surface was found where nothing is
};

struct RayError {
  RayOutcome outcome = RayOutcome::background;
  double units = 0;   ///< scene units; 0 where there are not two roots to compare
  double pixels = 0;  ///< likewise
};

/// `pixel_angle` as in TracerOptions.
[[nodiscard]] RayError error_of(const Ray& ray, const RayMeasure& found, const RayMeasure& reference,
                                double pixel_angle);

/// Over the rays where both found a surface; all lengths 0 where there are none. A quantile q is the least error that
/// at least a share q of them does not exceed.
struct ErrorSummary {
  std::uint64_t hits = 0;
  double median_pixels = 0, p99_pixels = 0, worst_pixels = 0;
  double worst_units = 0;
  std::uint64_t beyond_pixel = 0;  ///< of the hits: off by more than a pixel
  std::uint64_t missed = 0;
  std::uint64_t false_surfaces = 0;
  std::uint64_t holes = 0;  ///< of the missed: with a surface at all eight pixels around, so that they show as holes
};

/// Errors of a picture's centre rays, row by row, `width` a row.
[[nodiscard]] ErrorSummary summarise_errors(std::span<const RayError> errors, int width);

}  // namespace isl::render
