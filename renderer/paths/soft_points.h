// Points at which samples look at soft things, many at a time.
#pragma once

#include "renderer/numerics/sample_points.h"
#include "renderer/paths/pixel_sample.h"

#include <span>

namespace isl::render {

/// points[i] becomes places[i].point().
void set_points(std::span<const SoftPlace> places, std::span<UnitPoint> points);

/// A square through whose points the samples of a pixel look.
struct SampledSquare {
  SampleUse use;
  bool is_shared;  ///< the sequence is that of all shared squares; each of them takes another pair of its coordinates
  SobolPair pair;
};
/// The colour of a sample depends on its points in the pixel and on the lens at once, so both come from one sequence.
inline constexpr SampledSquare kLensSquare{SampleUse::lens, true, SobolPair::first};
[[nodiscard]] constexpr SampledSquare pixel_square(bool has_lens) {
  return {SampleUse::pixel, has_lens, has_lens ? SobolPair::second : SobolPair::first};
}

/// points[i] becomes the point of samples[i], from the middle of the square: both coordinates are in [-1/2, 1/2). The
/// first sample of a pixel has the middle, and all of them together are as even as those of the sequence are.
void set_centred_points(const SampledSquare& square, std::span<const PixelSample> samples, std::span<UnitPoint> points);

/// These functions for one vector width.
struct SoftPointLoops {
  void (*set)(std::span<const SoftPlace> places, std::span<UnitPoint> points);
  void (*set_centred)(const SampledSquare& square, std::span<const PixelSample> samples, std::span<UnitPoint> points);
};

}  // namespace isl::render
