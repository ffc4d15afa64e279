#include "renderer/film/film.h"

#include "base/check.h"
#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isl::render {
namespace {

/// Rows of `window` out of a layer that covers `rect`.
Layer cropped(const Layer& layer, const PixelRect& rect, const PixelRect& window) {
  Layer result(*layer.aov, 0);
  const std::size_t channels = layer.aov->channels.size();
  result.values.reserve(window.area() * channels);
  for (int y = window.y0; y < window.y1; ++y) {
    const auto row = layer.values.begin() + static_cast<std::ptrdiff_t>(rect.index(window.x0, y) * channels);
    result.values.insert(result.values.end(), row, row + static_cast<std::ptrdiff_t>(channels) * window.width());
  }
  return result;
}

}  // namespace

std::size_t picture_bytes(std::size_t pixels, const Aovs& aovs) {
  std::size_t layer_values = 0;
  for (const Aov* const aov : aovs) layer_values += aov->channels.size();
  // The film is there until the picture is developed from it, and the first pass as displayed takes less than that.
  const std::size_t film = 4 * sizeof(double) + sizeof(std::uint32_t) + sizeof(Certainty) + LostCounts::kPixelBytes +
                           layer_values * sizeof(double);
  const std::size_t image = (4 + layer_values) * sizeof(double);
  // A file is encoded from planes of floats; its bytes and the encoder's are at most as many. Beside a picture there
  // may be one of a layer, in false colours.
  const std::size_t encoding = 2 * (4 + layer_values) * sizeof(float) + (aovs.empty() ? 0 : 4 * sizeof(double));
  return pixels * (image + std::max(film, encoding));
}

Film::Film(const PixelRect& rect, const Aovs& aovs, const std::optional<WorkingSpace>& space)
    : rect_(rect),
      space_(space),
      sums_(4 * rect.area()),
      counts_(rect.area()),
      certainties_(rect.area()),
      lost_(rect.area()) {
  const auto is_asked = [&](const Aov& aov) { return std::ranges::find(aovs, &aov) != aovs.end(); };
  for (const SurfaceAov& row : surface_aovs()) {
    if (is_asked(row.aov)) surfaces_.push_back({&row, Layer(row.aov, rect.area())});
  }
  keeps_samples_ = is_asked(samples_aov());
  keeps_certainties_ = is_asked(uncertified_aov());
  if (is_asked(noise_aov())) noise_.resize(rect.area());
}

void Film::set_surface(std::size_t pixel, const SeenSurface& seen) {
  if (seen.hit->is_miss()) return;
  for (SurfaceLayer& surface : surfaces_) {
    double* const values = surface.layer.at(pixel);
    surface.row->fill(seen, values);
    // A value that is not finite (LostSamples) counts in the layer as a miss does.
    for (std::size_t i = 0; i < surface.row->aov.channels.size(); ++i) {
      if (!std::isfinite(values[i])) values[i] = surface.row->aov.for_miss;
    }
    surface.layer.round(pixel);
  }
}

std::uint64_t Film::count(const PixelRect& window, Certainty certainty) const {
  std::uint64_t pixels = 0;
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) pixels += certainties_[rect_.index(x, y)] == certainty ? 1 : 0;
  }
  return pixels;
}

void Film::set_mean(std::size_t pixel, const double* sum, double* mean) const {
  const std::uint32_t lost = lost_.of(pixel), count = counts_[pixel] - lost;
  const double divisor = std::max(count, 1U);
  for (std::size_t i = 0; i < 4; ++i) mean[i] = sum[i] / divisor;
  if (count == 0 && lost != 0) mean[3] = 1;
}

void Film::convert(double* mean) const {
  if (!space_) return;
  const Rgb linear = space_->to_linear({mean[0], mean[1], mean[2]});
  for (int i = 0; i < 3; ++i) mean[i] = linear[i];
}

std::array<double, 4> Film::mean(std::size_t pixel) const {
  std::array<double, 4> mean = raw_mean(pixel);
  convert(mean.data());
  return mean;
}

std::array<double, 4> Film::raw_mean(std::size_t pixel) const {
  std::array<double, 4> mean;
  set_mean(pixel, &sums_[4 * pixel], mean.data());
  return mean;
}

double Film::display_slope(double raw_mean) const {
  // A difference of half a code of eight bits: the curve is straight enough within it, and it is far above rounding.
  constexpr double kStep = 0.5 / 255;
  const double shown = std::clamp(raw_mean, 0.0, 1.0);
  double below[] = {shown - kStep, 0, 0}, above[] = {shown + kStep, 0, 0};
  convert(below);
  convert(above);
  return (srgb_from_linear(above[0]) - srgb_from_linear(below[0])) / (2 * kStep);
}

Image Film::develop(const PixelRect& window, int full_width, int full_height, bool has_alpha) {
  ISL_CHECK(window.empty() ||
                (window.x0 >= rect_.x0 && window.y0 >= rect_.y0 && window.x1 <= rect_.x1 && window.y1 <= rect_.y1),
            "window outside the film");
  Image image;
  image.full_width = full_width;
  image.full_height = full_height;
  image.window = window;
  image.has_alpha = has_alpha;
  std::vector<double> means = window == rect_ ? std::move(sums_) : std::vector<double>(4 * window.area());
  const double* const sums = window == rect_ ? means.data() : sums_.data();
  const std::size_t rows = window.empty() ? 0 : static_cast<std::size_t>(window.height());
  parallel_for(rows, [&](std::size_t row) {
    const int y = window.y0 + static_cast<int>(row);
    for (int x = window.x0; x < window.x1; ++x) {
      const std::size_t pixel = rect_.index(x, y);
      double* const mean = &means[4 * window.index(x, y)];
      set_mean(pixel, &sums[4 * pixel], mean);
      convert(mean);
      // The numbers of files end there.
      constexpr double kMost = std::numeric_limits<float>::max();
      if (std::abs(mean[0]) + std::abs(mean[1]) + std::abs(mean[2]) < kMost) continue;
      for (std::size_t i = 0; i < 3; ++i) mean[i] = std::clamp(mean[i], -kMost, kMost);
    }
  });
  image.rgba = std::move(means);
  sums_ = {};
  for (const SurfaceLayer& surface : surfaces_) image.layers.push_back(cropped(surface.layer, rect_, window));
  const auto add_numbers = [&](const Aov& aov, const auto& numbers) {
    Layer layer(aov, 0);
    layer.values.reserve(numbers.size());
    for (const auto number : numbers) layer.values.push_back(static_cast<double>(number));
    image.layers.push_back(cropped(layer, rect_, window));
  };
  if (keeps_samples_) add_numbers(samples_aov(), counts_);
  if (keeps_certainties_) add_numbers(uncertified_aov(), certainties_);
  if (!noise_.empty()) add_numbers(noise_aov(), noise_);
  return image;
}

}  // namespace isl::render
