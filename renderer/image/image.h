// A finished picture in memory, as rendering hands it to image files: linear light, and the layers asked for.
#pragma once

#include <cstddef>
#include <cstdint>
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

/// Which layers to keep beside the colour.
struct Aovs {
  bool depth = false;
  bool position = false;
  bool normal = false;
  bool albedo = false;
  bool primitive = false;
  bool samples = false;
  bool cost = false;
  bool error = false;
  bool solver_steps = false;
  bool missed = false;

  /// Whether any describes the surface seen.
  [[nodiscard]] bool any_of_surface() const { return depth || position || normal || albedo || primitive; }
  /// Whether any is measured by tracing the centre rays again (renderer/accuracy/measured_layers.h).
  [[nodiscard]] bool any_measured() const { return cost || error || solver_steps || missed; }
};

/// Layers, row by row over the picture's window; empty where not asked for. Those of the surface are of the pixel's
/// centre sample, unfiltered: an average of two depths or two numbers is on neither surface.
struct Layers {
  std::vector<float> depth;              ///< 1 value: from the eye along the ray, scene units; infinite for a miss
  std::vector<float> position;           ///< 3: world space; 0 for a miss
  std::vector<float> normal;             ///< 3: world space, outward, unit; 0 for a miss
  std::vector<float> albedo;             ///< 3: the pigment, linear; 0 for a miss
  std::vector<std::uint32_t> primitive;  ///< 1: the tracer's instance; 0xFFFFFFFF for a miss
  std::vector<std::uint32_t> samples;    ///< 1: camera rays that the pixel got
  // Of the centre ray alone, without the shading and shadows behind it:
  std::vector<float> cost;                  ///< 2: field evaluations; seconds, which no two runs have the same
  std::vector<float> error;                 ///< 2: off along the ray, in pixels, in scene units; infinite where missed ≠ 0
  std::vector<std::uint32_t> solver_steps;  ///< 1: cells of the grid whose fields were solved
  std::vector<std::uint32_t> missed;        ///< 1: 1 a surface is there and none was found, 2 the other way round, else 0
};

struct Image {
  int full_width = 0, full_height = 0;  ///< of the whole picture
  PixelRect window;                     ///< the part of it that is here
  bool has_alpha = false;
  std::vector<double> rgba;  ///< 4 a pixel: linear, not clipped; colour multiplied by alpha
  Layers layers;
};

}  // namespace isl::render
