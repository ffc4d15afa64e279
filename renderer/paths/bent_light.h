// Light that reaches the eye as a power of what it was, as mirrors with an `exponent` send it on. The sum along a path
// is then not linear any more: the paths behind such a mirror add to a sample of their own, whose finished colour is
// raised to the power and added to the sample before it.
#pragma once

#include "renderer/numerics/power.h"
#include "renderer/paths/path.h"

#include <cstdint>
#include <span>
#include <vector>

namespace isl::render {

/// The samples of one batch besides those of the camera. They are made from level to level of the paths, and finished
/// in the opposite order.
class BentLight {
 public:
  /// `samples`: the number of the camera's, which come first.
  void start(std::size_t samples) {
    first_ = samples;
    bends_.clear();
  }
  /// The number of a new sample, whose colour counts for the sample `of` times `factor` once it is raised to `power`.
  [[nodiscard]] std::uint32_t add(std::uint32_t of, const Rgb& factor, double power) {
    bends_.push_back({of, factor, power});
    return static_cast<std::uint32_t>(first_ + bends_.size() - 1);
  }
  /// The camera's sample to which a sample adds in the end.
  [[nodiscard]] std::uint32_t camera_sample(std::uint32_t sample) const {
    while (sample >= first_) sample = bends_[sample - first_].of;
    return sample;
  }
  /// The number of samples, the camera's included.
  [[nodiscard]] std::size_t sample_count() const { return first_ + bends_.size(); }

  /// Adds the samples from `count` on to those before them, and forgets them. No path may add to them any more.
  void finish_from(std::size_t count, std::span<Rgb> colours, std::span<Certainty> certainties) {
    while (sample_count() > count) {
      const std::size_t sample = sample_count() - 1;
      const Bend& bend = bends_.back();
      Rgb& colour = colours[sample];
      for (int i = 0; i < 3; ++i) colour[i] = colour[i] > 0 ? power(colour[i], bend.power) : 0;
      colours[bend.of] += bend.factor * colour;
      lower(certainties[bend.of], certainties[sample]);
      bends_.pop_back();
    }
  }

 private:
  struct Bend {
    std::uint32_t of;
    Rgb factor;
    double power;
  };
  std::size_t first_ = 0;
  std::vector<Bend> bends_;
};

}  // namespace isl::render
