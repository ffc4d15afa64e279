#include "renderer/film/block_noise.h"

#include "base/check.h"

#include <algorithm>
#include <bit>

namespace isl::render {
namespace {

/// Mean squares of half the differences of blocks of one size.
struct Scale {
  double square;  ///< the sum over `pairs`
  double pairs;
};

/// The largest blocks, of which there are few, and smaller ones that tell with the others how d falls.
constexpr std::size_t kLargeScales = 3, kSmallScales = 2;

/// From the largest blocks on, which are half of the samples that the mean is made of; each is half of the one before.
class Scales {
 public:
  void add(const Scale& scale) {
    if (count_ == squares_.size()) return;
    (count_ < kLargeScales ? large_pairs_ : small_pairs_) += scale.pairs;
    squares_[count_++] = scale.square;
  }
  [[nodiscard]] bool has_small() const { return count_ > kLargeScales; }
  /// If d falls like m^-p and `half` is 2^-p, the squares of the scales are those of n samples divided by half, half²,
  /// half³ … True if the small scales then give a greater d(n) than the large ones.
  [[nodiscard]] bool small_say_more(double half) const {
    return small_sum(half) * large_pairs_ > large_sum(half) * small_pairs_;
  }
  /// d(n), as all scales together say.
  [[nodiscard]] double mean(double half) const {
    return half * (large_sum(half) + small_sum(half)) / (large_pairs_ + small_pairs_);
  }

 private:
  // Each scale's square, brought to n samples by the powers of `half`, summed up; a factor of `half` is left out.
  [[nodiscard]] double large_sum(double half) const { return squares_[0] + half * (squares_[1] + half * squares_[2]); }
  [[nodiscard]] double small_sum(double half) const { return half * half * half * (squares_[3] + half * squares_[4]); }

  std::array<double, kLargeScales + kSmallScales> squares_{};
  double large_pairs_ = 0, small_pairs_ = 0;
  std::size_t count_ = 0;
};

/// 2^-p for the rate p at which both parts agree on d(n). The rate of random samples is 1 and that of smooth integrands
/// 3; as much below 1 as a few blocks err above it keeps the mean honest.
double half_of(const Scales& scales) {
  if (!scales.has_small()) return 0.5;
  double low = 0.125, high = 0.5946035575013605;  // rates of 3 and ¾
  constexpr int kHalvings = 6;                    // to a hundredth, far more exact than the few blocks can tell
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    const bool is_above = scales.small_say_more(middle);
    high = is_above ? middle : high;
    low = is_above ? low : middle;
  }
  return (low + high) / 2;
}

}  // namespace

void BlockNoise::clear() {
  // Only these levels were reached; what is in `partial_` is read where a level was set.
  const auto levels = static_cast<std::size_t>(std::bit_width(count_));
  std::fill_n(squares_.begin(), levels, Value{});
  count_ = 0;
  darkest_ = std::numeric_limits<double>::infinity();
  brightest_ = -darkest_;
}

void BlockNoise::add(const Rgb& colour, double alpha) {
  const double brightness = (colour.x + colour.y + colour.z) / 3;
  darkest_ = std::min(darkest_, brightness);
  brightest_ = std::max(brightest_, brightness);
  Value mean{colour.x, colour.y, colour.z, alpha};
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
  const double half = half_of(scales);
  return scales.mean(half) / (1 - half);
}

}  // namespace isl::render
