// A finished picture in memory, as rendering hands it to image files: linear light, and the layers that were asked for.
#pragma once

#include "renderer/image/aov.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace isl::render {

/// Pixels x0 ≤ x < x1, y0 ≤ y < y1; y counts from the top row.
struct PixelRect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  [[nodiscard]] int width() const { return x1 - x0; }
  [[nodiscard]] int height() const { return y1 - y0; }
  [[nodiscard]] bool empty() const { return x0 >= x1 || y0 >= y1; }
  [[nodiscard]] std::size_t area() const {
    return empty() ? 0 : static_cast<std::size_t>(width()) * static_cast<std::size_t>(height());
  }
  /// Number of a pixel within the rectangle, row by row. Precondition: it lies within.
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - y0) * static_cast<std::size_t>(width()) + static_cast<std::size_t>(x - x0);
  }
  friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

struct Image {
  int full_width = 0, full_height = 0;  ///< size of the whole picture
  PixelRect window;                     ///< the part of the whole picture that is stored here
  bool has_alpha = false;
  std::vector<double> rgba;   ///< 4 a pixel: linear, not clipped; colour multiplied by alpha
  std::vector<Layer> layers;  ///< those asked for, over the window

  /// Null if it was not asked for.
  [[nodiscard]] const Layer* layer(std::string_view name) const {
    for (const Layer& candidate : layers) {
      if (candidate.aov->name == name) return &candidate;
    }
    return nullptr;
  }
};

}  // namespace isl::render
