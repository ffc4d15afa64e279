// Decides which pixels deserve more than their centre sample. It looks once at the whole first pass, so that tiles do
// not show.
#pragma once

#include "renderer/film/film.h"

namespace isl::render {

/// A first pass as a display shows it: 4 floats a pixel (clipped sRGB red, green, blue; alpha), over the film's
/// rectangle. The threshold is compared in these values, because the eye judges by them: equal differences of code look
/// about equally strong, and a highlight ten times too bright for the display has no visible steps. Rows may be filled
/// by different threads.
class DisplayedPass {
 public:
  explicit DisplayedPass(const PixelRect& rect) : rect_(rect), values_(4 * rect.area()) {}

  void fill_row(const Film& film, int y);

  /// True if any channel differs by more than `threshold` from one of the (up to) 8 neighbours within the rectangle.
  [[nodiscard]] bool is_rough(int x, int y, double threshold) const;

 private:
  PixelRect rect_;
  std::vector<float> values_;
};

}  // namespace isl::render
