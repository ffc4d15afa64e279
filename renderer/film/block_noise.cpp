#include "renderer/film/block_noise.h"

#include "base/check.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace isl::render {
namespace {

/// Mean squares of half the differences of blocks of one size.
struct Scale {
  double square;  ///< the sum over `pairs`
  double pairs;
};

/// d(n) as scales of a part of the blocks estimate it.
struct Fit {
  double sum = 0, pairs = 0;
  /// The scale's d is 1/`share` of d(n).
  void add(const Scale& scale, double share) {
    sum += scale.square * share;
    pairs += scale.pairs;
  }
  [[nodiscard]] double mean() const { return sum / pairs; }
};

/// The largest blocks, of which there are few, and smaller ones that tell with the others how d falls.
constexpr std::size_t kLargeScales = 3, kSmallScales = 2;

struct Fits {
  Fit large, small;
};

/// From the largest blocks on, which are half of the samples that the mean is made of; each is half of the one before.
class Scales {
 public:
  void add(const Scale& scale) {
    if (count_ < list_.size()) list_[count_++] = scale;
  }
  [[nodiscard]] bool has_small() const { return count_ > kLargeScales; }
  /// If d falls like m^-p: `half` is 2^-p.
  [[nodiscard]] Fits fits(double half) const {
    Fits result;
    double share = half;
    for (std::size_t i = 0; i < count_; ++i, share *= half)
      (i < kLargeScales ? result.large : result.small).add(list_[i], share);
    return result;
  }

 private:
  std::array<Scale, kLargeScales + kSmallScales> list_{};
  std::size_t count_ = 0;
};

/// The rate p at which both parts agree on d(n). That of random samples is 1 and that of smooth integrands 3; as much
/// below 1 as a few blocks err above it keeps the mean honest.
double rate(const Scales& scales) {
  double low = 0.75, high = 3;
  if (!scales.has_small()) return 1;
  constexpr int kHalvings = 12;  // far more exact than the few blocks can tell
  for (int i = 0; i < kHalvings; ++i) {
    const double p = (low + high) / 2;
    const Fits at = scales.fits(std::exp2(-p));
    (at.small.mean() > at.large.mean() ? low : high) = p;
  }
  return (low + high) / 2;
}

}  // namespace

void BlockNoise::add(const Value& sample) {
  const double brightness = (sample[0] + sample[1] + sample[2]) / 3;
  darkest_ = std::min(darkest_, brightness);
  brightest_ = std::max(brightest_, brightness);
  Value mean = sample;
  std::size_t level = 0;
  for (std::uint32_t bit = count_; (bit & 1U) != 0; bit >>= 1, ++level) {
    for (std::size_t i = 0; i < kChannels; ++i) {
      const double half = (partial_[level][i] - mean[i]) / 2;
      squares_[level][i] += half * half;
      mean[i] = (partial_[level][i] + mean[i]) / 2;
    }
  }
  partial_[level] = mean;
  ++count_;
}

double BlockNoise::variance(const Value* before, const Value& weights) const {
  ISL_CHECK(std::has_single_bit(count_) && count_ >= 4, "{} samples", count_);
  const auto top = static_cast<std::size_t>(std::countr_zero(count_));
  const auto weighted = [&](const Value& squares) {
    double sum = 0;
    for (std::size_t i = 0; i < kChannels; ++i) sum += weights[i] * weights[i] * squares[i];
    return sum;
  };
  Scales scales;
  if (before) {
    Value squares;
    for (std::size_t i = 0; i < kChannels; ++i) {
      const double half = ((*before)[i] - partial_[top][i]) / 2;
      squares[i] = half * half;
    }
    scales.add({weighted(squares), 1});
  }
  for (std::size_t level = top; level-- > 0;)
    scales.add({weighted(squares_[level]), static_cast<double>(count_ >> (level + 1))});
  const double half = std::exp2(-rate(scales));
  const Fits at = scales.fits(half);
  return (at.large.sum + at.small.sum) / (at.large.pairs + at.small.pairs) / (1 - half);
}

}  // namespace isl::render
