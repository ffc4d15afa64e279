// Samples that are left out of the picture because their colour is no finite number, such as those of a pigment that
// divides by zero. One of them would make its whole pixel black or white, and with it whatever a blur or a filter makes
// of the pixel.
#pragma once

#include "base/source_span.h"
#include "renderer/film/tiles.h"
#include "renderer/shading/material.h"

#include <atomic>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <vector>

namespace isl::render {

/// The samples that a picture lost.
struct LostSamples {
  std::uint64_t samples = 0, pixels = 0;
  Pixel first;        ///< of the pixels, row by row
  OriginId origin{};  ///< the statement of what that pixel's first lost sample sees; unknown if it sees no object
};

/// The size of a sample, and the bound from which on it is lost; the bound leaves room for sums of any number of
/// samples.
[[nodiscard]] inline double size_of(const Rgb& colour, double alpha) {
  return std::abs(colour.x) + std::abs(colour.y) + std::abs(colour.z) + std::abs(alpha);
}
inline constexpr double kLostSize = 0x1p960;

/// True if the sample counts.
[[nodiscard]] inline bool is_finite(const Rgb& colour, double alpha) { return size_of(colour, alpha) < kLostSize; }

/// The number of lost samples, pixel by pixel. Pixels are independent: different threads may add to different ones.
class LostCounts {
 public:
  explicit LostCounts(std::size_t pixels) : pixels_(pixels) {}

  /// Bytes a pixel.
  static constexpr std::size_t kPixelBytes = sizeof(std::uint32_t) + sizeof(OriginId);

  void add(std::size_t pixel, OriginId origin) {
    std::call_once(made_, [&] {
      lost_.resize(pixels_);
      are_some_.store(true, std::memory_order_release);
    });
    Lost& lost = lost_[pixel];
    if (lost.count++ == 0) lost.origin = origin;
  }
  [[nodiscard]] std::uint32_t of(std::size_t pixel) const {
    return are_some_.load(std::memory_order_acquire) ? lost_[pixel].count : 0;
  }
  /// Those of a part of the film that covers `rect`.
  [[nodiscard]] LostSamples within(const PixelRect& window, const PixelRect& rect) const;

 private:
  struct Lost {
    std::uint32_t count = 0;
    OriginId origin{};
  };
  std::size_t pixels_;
  std::once_flag made_;
  std::atomic<bool> are_some_ = false;
  std::vector<Lost> lost_;  ///< by pixel, once there are some
};

}  // namespace isl::render
