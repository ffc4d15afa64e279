#include "renderer/film/adaptive.h"

#include "renderer/image/transfer.h"

#include <algorithm>
#include <cmath>

namespace isl::render {

void DisplayedPass::fill_row(const Film& film, int y) {
  for (int x = rect_.x0; x < rect_.x1; ++x) {
    const std::size_t pixel = rect_.index(x, y);
    const std::array<double, 4> value = film.mean(pixel);
    for (std::size_t i = 0; i < 3; ++i) values_[4 * pixel + i] = static_cast<float>(display_from_linear(value[i]));
    values_[4 * pixel + 3] = static_cast<float>(value[3]);
  }
}

bool DisplayedPass::is_rough(int x, int y, double threshold) const {
  const float* centre = &values_[4 * rect_.index(x, y)];
  for (int row = std::max(y - 1, rect_.y0); row < std::min(y + 2, rect_.y1); ++row) {
    for (int column = std::max(x - 1, rect_.x0); column < std::min(x + 2, rect_.x1); ++column) {
      const float* other = &values_[4 * rect_.index(column, row)];
      for (int i = 0; i < 4; ++i) {
        if (std::abs(static_cast<double>(centre[i]) - static_cast<double>(other[i])) > threshold) return true;
      }
    }
  }
  return false;
}

}  // namespace isl::render
