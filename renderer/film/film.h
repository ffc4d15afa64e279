// Sums of samples, pixel by pixel, and the layers of the surfaces seen. Samples of one pixel must come in a fixed order
// and from one thread at a time; different pixels are independent.
#pragma once

#include "renderer/film/lost_samples.h"
#include "renderer/film/surface_aovs.h"
#include "renderer/image/image.h"
#include "renderer/image/transfer.h"
#include "renderer/shading/material.h"

#include <array>
#include <optional>
#include <span>

namespace isl::render {

/// Bytes that a picture takes at most at a time on its way from the film to a file, with the layers in `aovs`.
[[nodiscard]] std::size_t picture_bytes(std::size_t pixels, const Aovs& aovs);

class Film {
 public:
  /// Covers `rect` of the picture. Every pixel starts without samples: transparent black. Of `aovs` those of surfaces
  /// and samples are kept. Samples are linear light, unless `space` is given: then they are colours of that space, and
  /// their means are converted.
  Film(const PixelRect& rect, const Aovs& aovs, const std::optional<WorkingSpace>& space = std::nullopt);

  /// Adds samples in their order. Precondition: colours are already multiplied by their `alphas`, and is_finite().
  void add_samples(std::size_t pixel, std::span<const Rgb> colours, std::span<const double> alphas) {
    double* const sum = &sums_[4 * pixel];
    double red = sum[0], green = sum[1], blue = sum[2], alpha = sum[3];
    for (std::size_t i = 0; i < colours.size(); ++i) {
      red += colours[i].x;
      green += colours[i].y;
      blue += colours[i].z;
      alpha += alphas[i];
    }
    sum[0] = red;
    sum[1] = green;
    sum[2] = blue;
    sum[3] = alpha;
    counts_[pixel] += static_cast<std::uint32_t>(colours.size());
  }
  /// Counts a sample of the pixel as lost: it was added as black and clear, and the mean is that of the others.
  /// `origin` is the statement of what it sees.
  void lose_sample(std::size_t pixel, OriginId origin) { lost_.add(pixel, origin); }
  /// Tells that a sample of the pixel comes soon: pixels of a tile lie rows apart, and a large film in no cache.
  void expect_sample(std::size_t pixel) const {
    __builtin_prefetch(&sums_[4 * pixel], 1);
    __builtin_prefetch(&counts_[pixel], 1);
  }
  void set_surface(std::size_t pixel, const SeenSurface& seen);
  /// A pixel is as sure as the worst of its samples.
  void lower_certainty(std::size_t pixel, Certainty to) { lower(certainties_[pixel], to); }

  /// Number of pixels of `window` with this certainty.
  [[nodiscard]] std::uint64_t count(const PixelRect& window, Certainty certainty) const;

  /// Lost samples of `window`.
  [[nodiscard]] LostSamples lost(const PixelRect& window) const { return lost_.within(window, rect_); }

  /// Mean of a pixel's samples that are not lost: linear red, green, blue, alpha; black if all are lost, and zeros if
  /// it has no samples.
  [[nodiscard]] std::array<double, 4> mean(std::size_t pixel) const;
  /// The same, in the space of the samples.
  [[nodiscard]] std::array<double, 4> raw_mean(std::size_t pixel) const;

  [[nodiscard]] std::uint32_t samples(std::size_t pixel) const { return counts_[pixel]; }
  /// How fast a display's codes change with a channel of such a mean. Beyond the display's range it is the slope at its
  /// end.
  [[nodiscard]] double display_slope(double raw_mean) const;

  /// For the layer of noise (noise_aov()).
  void set_noise(std::size_t pixel, double noise) {
    if (!noise_.empty()) noise_[pixel] = static_cast<float>(noise);
  }

  [[nodiscard]] const PixelRect& rect() const { return rect_; }
  /// True if samples are linear light, false if they are colours of the scene's working space.
  [[nodiscard]] bool is_linear() const { return !space_; }
  /// True if the film has layers that set_surface() fills.
  [[nodiscard]] bool keeps_surfaces() const { return !surfaces_.empty(); }

  /// The part `window` (within rect()) as a picture of a whole of the given size, made on as many threads as loops have
  /// here. Gives up the sums of colours, of which there is no mean() afterwards: where the window is all of the film,
  /// the picture takes their place, because a large one takes a noticeable time to move.
  [[nodiscard]] Image develop(const PixelRect& window, int full_width, int full_height, bool has_alpha);

 private:
  /// Writes the mean of a pixel's samples from their sum, in the space of the samples.
  void set_mean(std::size_t pixel, const double* sum, double* mean) const;
  /// Makes a mean of samples linear.
  void convert(double* mean) const;

  PixelRect rect_;
  std::optional<WorkingSpace> space_;
  std::vector<double> sums_;  ///< 4 a pixel
  std::vector<std::uint32_t> counts_;
  std::vector<Certainty> certainties_;
  LostCounts lost_;
  struct SurfaceLayer {
    const SurfaceAov* row;
    Layer layer;  ///< over rect_
  };
  std::vector<SurfaceLayer> surfaces_;
  std::vector<float> noise_;  ///< if the layer is asked for
  bool keeps_samples_ = false, keeps_certainties_ = false;
};

}  // namespace isl::render
