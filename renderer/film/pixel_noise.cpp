#include "renderer/film/pixel_noise.h"

#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace isl::render {

namespace {

/// Steps of the table of a display's slopes: as fine as the difference by which a slope is told.
constexpr int kSlopeSteps = 512;

/// The weights by which the deviations of a pixel and its neighbours are averaged, along each axis.
constexpr double kWeights[] = {1, 2, 1};

/// The error that a pixel may have because of what its samples miss, in codes of a display. `span` is the difference of
/// the brightest and the darkest sample of the pixel and its neighbours.
double missed(double slope, double span, std::uint32_t samples) {
  // Of n evenly spread samples none falls into a part of the size a < 1/n with the probability 1 - n a. If all sizes
  // are equally likely beforehand, the mean of a² is 1/(6 n²) then. What is there differs by no more than all samples
  // around do; the mean square of such a difference is a third of the greatest.
  constexpr double kShare = 0.2357022603955158;  // √(1/18)
  return kShare * slope * span / samples;
}

}  // namespace

PixelNoise::PixelNoise(Film& film)
    : film_(film), pixels_(film.rect().area()), chosen_(pixels_.size(), 1), chosen_before_(pixels_.size(), 1) {
  for (int i = 0; i <= kSlopeSteps; ++i)
    slopes_.push_back(film.display_slope(static_cast<double>(i) / kSlopeSteps) / std::sqrt(3.0));
}

BlockNoise::Value PixelNoise::slopes(const BlockNoise::Value& mean) const {
  BlockNoise::Value slopes{0, 0, 0, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    const double place = std::min(std::max(0.0, mean[i]), 1.0) * kSlopeSteps;
    const std::size_t step = std::min(static_cast<std::size_t>(place), std::size_t{kSlopeSteps - 1});
    const double share = place - static_cast<double>(step);
    slopes[i] = slopes_[step] + share * (slopes_[step + 1] - slopes_[step]);
  }
  return slopes;
}

/// The sums and extremes of three pixels, one above the other.
struct PixelNoise::Column {
  double deviations = 0, weights = 0;  ///< the weighted sum of their deviations, and that of the weights
  float darkest = std::numeric_limits<float>::infinity(), brightest = -std::numeric_limits<float>::infinity();
  bool has_news = false;  ///< one of them was chosen for the last pass

  void add(const Column& other, double weight) {
    deviations += weight * other.deviations;
    weights += weight * other.weights;
    darkest = std::min(darkest, other.darkest);
    brightest = std::max(brightest, other.brightest);
    has_news |= other.has_news;
  }
};

/// The columns around the pixels of a row, with an empty one on either side.
void PixelNoise::set_columns(int y, std::vector<Column>& columns) const {
  const PixelRect& rect = film_.rect();
  columns.assign(static_cast<std::size_t>(rect.width()) + 2, {});
  for (int row = std::max(y - 1, rect.y0); row < std::min(y + 2, rect.y1); ++row) {
    const double weight = kWeights[row - y + 1];
    const std::size_t first = rect.index(rect.x0, row);
    for (std::size_t i = 0; i < columns.size() - 2; ++i) {
      const Pixel& pixel = pixels_[first + i];
      const bool is_seen = film_.samples(first + i) != 0;  // not if the picture was stopped
      columns[i + 1].add({is_seen ? pixel.deviation : 0, is_seen ? 1.0 : 0.0, pixel.darkest, pixel.brightest,
                          chosen_before_[first + i] != 0},
                         weight);
    }
  }
}

std::uint64_t PixelNoise::choose(double most, std::uint32_t most_samples) {
  const PixelRect& rect = film_.rect();
  std::swap(chosen_, chosen_before_);
  std::atomic<std::uint64_t> chosen = 0;
  parallel_for(static_cast<std::size_t>(rect.height()), [&](std::size_t row) {
    std::vector<Column> columns;
    const int y = rect.y0 + static_cast<int>(row);
    set_columns(y, columns);
    const std::size_t first = rect.index(rect.x0, y);
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < columns.size() - 2; ++i) {
      const std::size_t at = first + i;
      Pixel& pixel = pixels_[at];
      const std::uint32_t samples = film_.samples(at);
      Column around;
      for (std::size_t k = 0; k < 3; ++k) around.add(columns[i + k], kWeights[k]);
      if (samples != 0 && around.has_news) {
        const double may_miss = missed(pixel.slope, static_cast<double>(around.brightest - around.darkest), samples);
        // Deviations are averaged and not their squares, which those of a single pixel would rule. A detail no larger
        // than the pixel is seen by it alone, so half of its own deviation counts at least.
        const double deviation = std::max(around.deviations / around.weights, pixel.deviation / 2);
        pixel.noise = static_cast<float>(std::sqrt(deviation * deviation / samples + may_miss * may_miss));
        film_.set_noise(at, static_cast<double>(pixel.noise));
      }
      chosen_[at] = static_cast<double>(pixel.noise) > most && samples < most_samples ? 1 : 0;
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
  BlockNoise::Value slope = slopes(mean);
  for (std::size_t i = 0; i < 3; ++i) {
    // A channel is white in the display if its mean is certainly above 1: three standard deviations of what is left.
    BlockNoise::Value channel{};
    channel[i] = 1;
    if (mean[i] > 1 && mean[i] - 1 > 3 * std::sqrt(samples.variance(has_earlier ? &before : nullptr, channel)))
      slope[i] = 0;
  }
  Pixel& noise = pixels_[pixel];
  noise.deviation = std::sqrt(samples.variance(has_earlier ? &before : nullptr, slope) * film_.samples(pixel));
  noise.slope = std::hypot(slope[0], slope[1], slope[2]);
  noise.darkest = std::min(noise.darkest, static_cast<float>(samples.darkest()));
  noise.brightest = std::max(noise.brightest, static_cast<float>(samples.brightest()));
}

}  // namespace isl::render
