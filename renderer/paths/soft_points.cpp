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

constexpr std::size_t kTogether = 8;

void fill_points(const PointSequence& sequence, const SquarePlace& middle, std::uint32_t first,
                 std::span<UnitPoint> points) {
  const std::uint32_t seed_of_u = sequence.seed_of_u(), seed_of_v = sequence.seed_of_v();
  std::uint32_t u[kTogether], v[kTogether];
  for (std::size_t begin = 0; begin < points.size(); begin += kTogether) {
    const std::uint32_t number = first + static_cast<std::uint32_t>(begin);
    for (std::uint32_t i = 0; i < kTogether; ++i) u[i] = detail::scrambled(number + i, sequence.order);
    if (sequence.pair == SobolPair::first) {
      for (std::size_t i = 0; i < kTogether; ++i) v[i] = detail::reversed_second_sobol(u[i]);
    } else {
      for (std::size_t i = 0; i < kTogether; ++i) {
        v[i] = detail::kFourthSobol[u[i]];
        u[i] = detail::kThirdSobol[u[i]];
      }
    }
    for (std::size_t i = 0; i < kTogether; ++i) {
      u[i] = detail::in_square(u[i], seed_of_u) - middle.u;
      v[i] = detail::in_square(v[i], seed_of_v) - middle.v;
    }
    // A difference, as a whole number with a sign, is measured from the middle.
    for (std::size_t i = 0; i < std::min(kTogether, points.size() - begin); ++i)
      points[begin + i] = {static_cast<std::int32_t>(u[i]) * 0x1p-32, static_cast<std::int32_t>(v[i]) * 0x1p-32};
  }
}

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
      const PointSequence sequence{seed[i], seed[i]};
      const SquarePlace place = sequence.place(number[i]);
      u[i] = place.u;
      v[i] = place.v;
    }
    for (std::size_t i = 0; i < count; ++i) points[begin + i] = SquarePlace{u[i], v[i]}.point();
  }
}

const SoftPointLoops* soft_point_loops() {
  static constexpr SoftPointLoops kLoops{fill_points, set_points};
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

void CentredPoints::fill(std::uint32_t first, std::span<UnitPoint> points) const {
  loops().fill(sequence_, middle_, first, points);
}

void set_points(std::span<const SoftPlace> places, std::span<UnitPoint> points) { loops().set(places, points); }

}  // namespace isl::render
#endif
