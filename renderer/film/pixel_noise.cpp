#include "renderer/film/pixel_noise.h"

#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace isl::render {

PixelRect PixelNoise::around(int x, int y) const {
  const PixelRect& rect = film_.rect();
  return {std::max(x - 1, rect.x0), std::max(y - 1, rect.y0), std::min(x + 2, rect.x1), std::min(y + 2, rect.y1)};
}

/// True if one of the pixels was chosen for the last pass.
bool PixelNoise::has_news(const PixelRect& around) const {
  for (int y = around.y0; y < around.y1; ++y) {
    const auto row = chosen_before_.begin() + static_cast<std::ptrdiff_t>(film_.rect().index(around.x0, y));
    if (std::any_of(row, row + around.width(), [](std::uint8_t chosen) { return chosen != 0; })) return true;
  }
  return false;
}

/// The deviation of a sample at (x, y), as the pixel and its neighbours tell. Deviations are averaged and not their
/// squares, which those of a single pixel would rule. A detail no larger than the pixel is seen by it alone, so half of
/// its own deviation counts at least.
double PixelNoise::deviation(int x, int y, const PixelRect& around) const {
  double sum = 0, weights = 0;
  for (int row = around.y0; row < around.y1; ++row) {
    for (int column = around.x0; column < around.x1; ++column) {
      const std::size_t at = film_.rect().index(column, row);
      if (film_.samples(at) == 0) continue;  // the picture was stopped
      const double weight = (column == x ? 2 : 1) * (row == y ? 2 : 1);
      sum += weight * pixels_[at].deviation;
      weights += weight;
    }
  }
  return std::max(sum / weights, pixels_[film_.rect().index(x, y)].deviation / 2);
}

/// The error that a pixel may have because of what its samples miss, in codes of a display.
double PixelNoise::missed(std::size_t pixel, const PixelRect& around) const {
  // Of n evenly spread samples none falls into a part of the size a < 1/n with the probability 1 - n a. If all sizes
  // are equally likely beforehand, the mean of a² is 1/(6 n²) then. What is there differs by no more than all samples
  // around do; the mean square of such a difference is a third of the greatest.
  constexpr double kShare = 0.2357022603955158;  // √(1/18)
  double darkest = std::numeric_limits<double>::infinity(), brightest = -darkest;
  for (int y = around.y0; y < around.y1; ++y) {
    for (int x = around.x0; x < around.x1; ++x) {
      const Pixel& other = pixels_[film_.rect().index(x, y)];
      darkest = std::min(darkest, static_cast<double>(other.darkest));
      brightest = std::max(brightest, static_cast<double>(other.brightest));
    }
  }
  return kShare * pixels_[pixel].slope * (brightest - darkest) / film_.samples(pixel);
}

std::uint64_t PixelNoise::choose(double most, std::uint32_t most_samples) {
  const PixelRect& rect = film_.rect();
  std::swap(chosen_, chosen_before_);
  std::atomic<std::uint64_t> chosen = 0;
  parallel_for(static_cast<std::size_t>(rect.height()), [&](std::size_t row) {
    const int y = rect.y0 + static_cast<int>(row);
    std::uint64_t count = 0;
    for (int x = rect.x0; x < rect.x1; ++x) {
      const std::size_t at = rect.index(x, y);
      Pixel& pixel = pixels_[at];
      const PixelRect neighbours = around(x, y);
      if (film_.samples(at) != 0 && has_news(neighbours)) {
        const double may_miss = missed(at, neighbours);
        const double own = deviation(x, y, neighbours);
        pixel.noise = static_cast<float>(std::sqrt(own * own / film_.samples(at) + may_miss * may_miss));
        film_.set_noise(at, static_cast<double>(pixel.noise));
      }
      chosen_[at] = static_cast<double>(pixel.noise) > most && film_.samples(at) < most_samples ? 1 : 0;
      count += chosen_[at];
    }
    chosen += count;
  });
  return chosen;
}

std::uint64_t PixelNoise::count_above(const PixelRect& window, double noise) const {
  std::uint64_t count = 0;
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x)
      count += static_cast<double>(pixels_[film_.rect().index(x, y)].noise) > noise ? 1 : 0;
  }
  return count;
}

void PixelNoise::finish(std::size_t pixel, const BlockNoise& samples) {
  const BlockNoise::Value mean = film_.raw_mean(pixel);
  const bool has_earlier = film_.samples(pixel) == 2 * samples.count();
  BlockNoise::Value before = mean;
  if (has_earlier) {
    const BlockNoise::Value& last = samples.mean();
    for (std::size_t i = 0; i < before.size(); ++i) before[i] = 2 * mean[i] - last[i];
  }
  BlockNoise::Value slopes = film_.display_slopes(mean);
  for (std::size_t i = 0; i < 3; ++i) {
    // A channel is white in the display if its mean is certainly above 1: three standard deviations of what is left.
    BlockNoise::Value channel{};
    channel[i] = 1;
    if (mean[i] > 1 && mean[i] - 1 > 3 * std::sqrt(samples.variance(has_earlier ? &before : nullptr, channel)))
      slopes[i] = 0;
  }
  Pixel& noise = pixels_[pixel];
  noise.deviation = std::sqrt(samples.variance(has_earlier ? &before : nullptr, slopes) * film_.samples(pixel));
  noise.slope = std::hypot(slopes[0], slopes[1], slopes[2]);
  noise.darkest = std::min(noise.darkest, static_cast<float>(samples.darkest()));
  noise.brightest = std::max(noise.brightest, static_cast<float>(samples.brightest()));
}

}  // namespace isl::render
