// This file is compiled once for each vector width (Highway's foreach_target includes it again). Every loop does one
// step for many points, so that the compiler does as many of them at once as registers hold.
#include "renderer/paths/soft_points.h"

#include <algorithm>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/paths/soft_points.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "renderer/simd/fallback_target.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

constexpr std::size_t kTogether = 32;

void set_points(std::span<const SoftPlace> places, std::span<UnitPoint> points) {
  std::uint32_t number[kTogether], seed[kTogether], u[kTogether], v[kTogether];
  for (std::size_t begin = 0; begin < places.size(); begin += kTogether) {
    const std::size_t count = std::min(kTogether, places.size() - begin);
    for (std::size_t i = 0; i < kTogether; ++i) {
      const SoftPlace& place = places[begin + std::min(i, count - 1)];
      number[i] = place.number;
      seed[i] = derived_seed(place.seed, place.use);
    }
    for (std::size_t i = 0; i < kTogether; ++i) {
      const SquarePlace place = PointSequence{seed[i], seed[i]}.place(number[i]);
      u[i] = place.u;
      v[i] = place.v;
    }
    for (std::size_t i = 0; i < count; ++i) points[begin + i] = SquarePlace{u[i], v[i]}.point();
  }
}

/// Scrambles a coordinate of Sobol's sequence, given with its bits reversed, and measures it from the middle of the
/// square: a whole number with a sign, in units of 2⁻³². The coordinate of number 0, which is 0, comes to the middle.
/// All points change the same digits as it does, so that intervals that come from halving the side stay such intervals.
/// The first point is then at the lower end of its interval instead of anywhere in it; half of the seeds mirror the
/// points, so that this favours no side.
HWY_INLINE std::uint32_t from_middle(std::uint32_t reversed, std::uint32_t seed) {
  const std::uint32_t mirrors = 0U - (seed >> 31);
  const std::uint32_t place = detail::in_square(reversed, seed) ^ detail::in_square(0, seed);
  return (place ^ mirrors) - mirrors;  // the negative of the number, if all bits of `mirrors` are set
}

void set_centred(const SampledSquare& square, std::span<const PixelSample> samples, std::span<UnitPoint> points) {
  const auto use = static_cast<std::uint32_t>(square.use);
  std::uint32_t number[kTogether], seed[kTogether], order[kTogether], u[kTogether], v[kTogether];
  for (std::size_t begin = 0; begin < samples.size(); begin += kTogether) {
    const std::size_t count = std::min(kTogether, samples.size() - begin);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < kTogether; ++i) {
      const PixelSample& sample = samples[begin + std::min(i, count - 1)];
      number[i] = sample.index;
      order[i] = sample.seed;
      bits |= sample.index;
    }
    for (std::size_t i = 0; i < kTogether; ++i) seed[i] = derived_seed(order[i], use);
    if (!square.is_shared) std::copy(std::begin(seed), std::end(seed), std::begin(order));
    for (std::size_t i = 0; i < kTogether; ++i) u[i] = detail::shuffled(number[i], order[i]);
    if (square.pair == SobolPair::second) {
      std::uint32_t partner[kTogether] = {};
      for (std::uint32_t bit = 0; bit < 32 && bits >> bit != 0; ++bit) {
        const std::uint32_t of_bit = detail::partner_of_bit(bit);
        for (std::size_t i = 0; i < kTogether; ++i) partner[i] ^= (0U - (u[i] >> bit & 1U)) & of_bit;
      }
      std::copy(std::begin(partner), std::end(partner), std::begin(u));
    }
    for (std::size_t i = 0; i < kTogether; ++i) v[i] = detail::reversed_second_sobol(u[i]);
    for (std::size_t i = 0; i < kTogether; ++i) u[i] = from_middle(u[i], derived_seed(seed[i], 1));
    for (std::size_t i = 0; i < kTogether; ++i) v[i] = from_middle(v[i], derived_seed(seed[i], 2));
    for (std::size_t i = 0; i < count; ++i)
      points[begin + i] = {static_cast<std::int32_t>(u[i]) * 0x1p-32, static_cast<std::int32_t>(v[i]) * 0x1p-32};
  }
}

const SoftPointLoops* soft_point_loops() {
  static constexpr SoftPointLoops kLoops{set_points, set_centred};
  return &kLoops;
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "renderer/simd/vector_targets.h"

namespace isl::render {
namespace {

const SoftPointLoops& loops() {
  static constexpr VectorTarget<SoftPointLoops> kTargets[] = {ISL_VECTOR_TARGETS(soft_point_loops)};
  static const SoftPointLoops& widest = *entry_points_of<SoftPointLoops>(kTargets, "");
  return widest;
}

}  // namespace

void set_points(std::span<const SoftPlace> places, std::span<UnitPoint> points) { loops().set(places, points); }

void set_centred_points(const SampledSquare& square, std::span<const PixelSample> samples,
                        std::span<UnitPoint> points) {
  loops().set_centred(square, samples, points);
}

}  // namespace isl::render
#endif
