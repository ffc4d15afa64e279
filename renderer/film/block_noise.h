// An honest estimate of how far a mean of evenly spread samples is from its limit.
//
// Such samples converge faster than random ones, so their variance over their number says too much. Instead, means of
// neighbouring blocks of m samples are compared, for m = 1, 2, 4 …: let d(m) be the expected square of half their
// difference, and v(m) the variance of the mean of a block. As A and B vary alike,
//   v(2m) = Var((A + B)/2) = v(m) − Var((A − B)/2) = v(m) − d(m),
// so that v(n) is the sum of all d(m) for m = n, 2n, 4n … If d falls like m^-p, this is
//   v(n) = d(n)/(1 − 2^-p),
// and p comes from the blocks within the samples: it is 1 for random ones, and up to 3 where the integrand is smooth
// (Owen, Scrambled net variance for integrals of smooth functions, 1997).
#pragma once

#include "renderer/shading/material.h"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace isl::render {

/// The samples of one pixel in one round: 2^k of them, in their order.
class BlockNoise {
 public:
  static constexpr int kChannels = 4;
  using Value = std::array<double, kChannels>;

  void clear();
  void add(const Rgb& colour, double alpha);
  [[nodiscard]] std::uint32_t count() const { return count_; }
  /// The least and the greatest mean of a sample's three colours.
  [[nodiscard]] double darkest() const { return darkest_; }
  [[nodiscard]] double brightest() const { return brightest_; }
  /// Precondition: count() is a power of two.
  [[nodiscard]] const Value& mean() const { return partial_[static_cast<std::size_t>(std::countr_zero(count_))]; }

  /// The variance of the mean of all samples added and of as many before them, whose mean was `before`, or of the
  /// samples added alone if `before` is null. Channels count by the squares of `weights`. Precondition: count() is a
  /// power of two, at least 4.
  [[nodiscard]] double variance(const Value* before, const Value& weights) const;

 private:
  static constexpr int kLevels = 16;      ///< blocks of up to 2^15 samples
  std::array<Value, kLevels> partial_{};  ///< by level, the mean of a block that waits for its neighbour
  std::array<Value, kLevels> squares_{};  ///< by level, sums of squares of half the differences of blocks
  std::uint32_t count_ = 0;
  double darkest_ = std::numeric_limits<double>::infinity();
  double brightest_ = -std::numeric_limits<double>::infinity();
};

}  // namespace isl::render
