// The points at which a pixel's samples look at soft things. Each sample of a pixel takes its share of the points of
// every integral (the area of a light, the lens, directions), so that integrals share the samples instead of
// multiplying them.
#pragma once

#include "renderer/numerics/sample_points.h"

#include <algorithm>
#include <cstdint>

namespace isl::render {

/// The integrals over which a path's points are spread, each with a sequence of its own.
enum class SampleUse : std::uint8_t { pixel, lens, light_area, lit_from_area, occlusion, sky, bounce };

/// A sample among those of its pixel.
struct PixelSample {
  std::uint32_t seed = 0;   ///< the pixel's
  std::uint32_t index = 0;  ///< counts the pixel's samples
  std::uint32_t of = 1;     ///< the number of samples that share the points of an integral

  /// The number of points that this sample takes of `wanted` ones for the pixel; at least 1.
  [[nodiscard]] std::uint32_t share_of(int wanted) const {
    const auto all = static_cast<std::uint32_t>(std::max(wanted, 1));
    return (all - 1) / of + 1;
  }
  /// The sample's point number `i` of its `share`. `level` and `number` tell integrals of one use apart: the segments
  /// of a path, and the lights.
  [[nodiscard]] UnitPoint point(SampleUse use, std::uint32_t share, std::uint32_t i, std::uint32_t level = 0,
                                std::uint32_t number = 0) const {
    return sample_point(seed_of(use, level, number), index * share + i);
  }
  /// A seed for numbers of this sample alone, for one of the integrals.
  [[nodiscard]] std::uint32_t own_seed(SampleUse use, std::uint32_t level, std::uint32_t number) const {
    return derived_seed(seed_of(use, level, number), index);
  }
  /// The seed of the pixel's sequence for one of the integrals.
  [[nodiscard]] std::uint32_t seed_of(SampleUse use, std::uint32_t level, std::uint32_t number) const {
    return derived_seed(seed, static_cast<std::uint32_t>(use) | level << 4 | number << 14);
  }
};

/// The points of the lens through which the samples of a pixel look.
[[nodiscard]] constexpr CentredPoints points_on_lens(std::uint32_t seed) {
  return CentredPoints({seed, derived_seed(seed, static_cast<std::uint32_t>(SampleUse::lens))});
}
/// The points of the pixel through which its samples look. With a lens, what a sample sees depends on its points in the
/// pixel and on the lens at once, so both come from one sequence.
[[nodiscard]] constexpr CentredPoints points_in_pixel(std::uint32_t seed, bool has_lens) {
  const std::uint32_t own = derived_seed(seed, static_cast<std::uint32_t>(SampleUse::pixel));
  return CentredPoints(has_lens ? PointSequence{seed, own, SobolPair::second} : PointSequence{own, own});
}

/// The seed of a pixel of the picture.
[[nodiscard]] constexpr std::uint32_t pixel_seed(int x, int y) {
  return derived_seed(derived_seed(0, static_cast<std::uint32_t>(x)), static_cast<std::uint32_t>(y));
}

}  // namespace isl::render
