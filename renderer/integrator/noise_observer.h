// Puts the samples of one pixel after the other together, and tells the pixel's noise when the last one has come.
#pragma once

#include "renderer/film/pixel_noise.h"
#include "renderer/integrator/sampler.h"

namespace isl::render {

class NoiseObserver final : public SampleObserver {
 public:
  /// `present` holds the samples that have come of a pixel whose others are in the next batch.
  NoiseObserver(PixelNoise& noise, BlockNoise& present) : noise_(noise), present_(present) {}

  void add(const CameraSample& last, std::span<const Rgb> colours, std::span<const double> alphas) override {
    for (std::size_t i = 0; i < colours.size(); ++i) present_.add(colours[i], alphas[i]);
    if (!last.is_last) return;
    noise_.finish(last.pixel, present_);
    present_.clear();
  }

 private:
  PixelNoise& noise_;
  BlockNoise& present_;
};

}  // namespace isl::render
