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

/// A point of the sequence that a pixel has for one of its integrals.
struct SoftPlace {
  std::uint32_t seed = 0;    ///< the pixel's
  std::uint32_t use = 0;     ///< differs for each integral
  std::uint32_t number = 0;  ///< in the sequence

  [[nodiscard]] UnitPoint point() const { return sample_point(derived_seed(seed, use), number); }
};

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
  /// The place, in its pixel's sequence, of point number `i` of the sample's `share`. Each segment of a path has
  /// another `level`, and each light another `number`, so that integrals of one use have sequences of their own.
  [[nodiscard]] SoftPlace place(SampleUse use, std::uint32_t share, std::uint32_t i, std::uint32_t level = 0,
                                std::uint32_t number = 0) const {
    return {seed, code_of(use, level, number), index * share + i};
  }
  [[nodiscard]] UnitPoint point(SampleUse use, std::uint32_t share, std::uint32_t i, std::uint32_t level = 0,
                                std::uint32_t number = 0) const {
    return place(use, share, i, level, number).point();
  }
  /// A seed for numbers of this sample alone, for one of the integrals.
  [[nodiscard]] std::uint32_t own_seed(SampleUse use, std::uint32_t level, std::uint32_t number) const {
    return derived_seed(derived_seed(seed, code_of(use, level, number)), index);
  }

 private:
  [[nodiscard]] static std::uint32_t code_of(SampleUse use, std::uint32_t level, std::uint32_t number) {
    return static_cast<std::uint32_t>(use) | level << 4 | number << 14;
  }
};

/// The seed of a pixel of the picture.
[[nodiscard]] constexpr std::uint32_t pixel_seed(int x, int y) {
  return derived_seed(derived_seed(0, static_cast<std::uint32_t>(x)), static_cast<std::uint32_t>(y));
}

}  // namespace isl::render
