#include "renderer/film/lost_samples.h"

namespace isl::render {

LostSamples LostCounts::within(const PixelRect& window, const PixelRect& rect) const {
  LostSamples sum;
  if (!are_some_.load(std::memory_order_acquire)) return sum;
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      const Lost& lost = lost_[rect.index(x, y)];
      if (lost.count == 0) continue;
      if (sum.pixels++ == 0) {
        sum.first = {x, y};
        sum.origin = lost.origin;
      }
      sum.samples += lost.count;
    }
  }
  return sum;
}

}  // namespace isl::render
