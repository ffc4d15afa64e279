// This file is compiled once for each vector width (Highway's foreach_target includes it again). Terms are computed
// side by side and added one after the other, so that every width gives the same digits.
#include "renderer/values/lattice_noise.h"

#include "renderer/values/integer.h"
#include "renderer/values/noise_tables.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/values/lattice_noise.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "renderer/simd/fallback_target.h"

HWY_BEFORE_NAMESPACE();
namespace isl::values {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using scene::Vec3;

/// Up to four terms side by side.
using Terms = hn::CappedTag<double, 4>;
using TermsVector = hn::Vec<Terms>;
constexpr Terms kTerms;
constexpr std::size_t kLanes = hn::MaxLanes(kTerms);

/// Origin of the lattice coordinates, so that those of usual scenes are positive.
constexpr std::uint32_t kLatticeOrigin = 10000;

/// The numbers of the lattice points at the corners of a cell: x first, then y, then z. `lattice` is the near corner.
HWY_INLINE void find_corners(const NoiseTables& tables, const double (&lattice)[3], std::uint16_t* corners) {
  constexpr std::uint32_t kMask = NoiseTables::kHashes - 1;
  const std::uint16_t* const hash = tables.hash.data();
  const std::uint16_t* const point = tables.point.data();
  std::uint32_t at[3];
  for (int i = 0; i < 3; ++i) at[i] = static_cast<std::uint32_t>(to_integer(lattice[i])) + kLatticeOrigin;
  const std::uint32_t of_x[2] = {hash[at[0] & kMask], hash[(at[0] + 1) & kMask]};
  const std::uint32_t y[2] = {at[1] & kMask, (at[1] + 1) & kMask}, z[2] = {at[2] & kMask, (at[2] + 1) & kMask};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::uint32_t of_xy = hash[of_x[i % 2] ^ y[i / 2]];
    corners[i] = point[of_xy ^ z[0]];
    corners[i + 4] = point[of_xy ^ z[1]];
  }
}

/// The lattice cell around a point. Arrays are by axis, and by side, the near one first.
struct Cell {
  double from_side[3][2];  ///< in edges of the cell
  double weights[3][2];
  std::uint16_t corners[8];
};

HWY_INLINE Cell cell_around(const NoiseTables& tables, const Vec3& p) {
  Cell cell;
  double lattice[3];
  for (int i = 0; i < 3; ++i) {
    lattice[i] = std::floor(p[i]);
    const double t = std::isfinite(p[i]) ? p[i] - lattice[i] + 0.0 : 0.0;  // the sum makes 0 of −0
    cell.from_side[i][0] = t;
    cell.from_side[i][1] = t - 1;
    cell.weights[i][1] = t * t * (3 - 2 * t);
    cell.weights[i][0] = 1 - cell.weights[i][1];
  }
  find_corners(tables, lattice, cell.corners);
  return cell;
}

/// The cells of several octaves are found before their sums, so that no octave waits for the one before it.
struct Cells {
  static constexpr std::size_t kMost = 8;
  Cell of[kMost];

  /// Sets the cells of the first `count` octaves. `scale` is that of the first, and becomes that of the next after
  /// them.
  HWY_INLINE void set(const NoiseTables& tables, const Vec3& p, double lambda, std::size_t count, double& scale) {
    for (std::size_t i = 0; i < count; ++i, scale *= lambda) of[i] = cell_around(tables, p * scale);
  }
};

/// The terms of four corners side by side, or of as many as there are lanes, from corner `first` on.
struct Slopes {
  TermsVector half_value, x, y, z;
};

HWY_INLINE Slopes slopes_of(const double* const (&corner)[4], [[maybe_unused]] std::size_t first) {
#if HWY_TARGET == HWY_SCALAR
  const auto term = [&](std::size_t i) HWY_ATTR { return hn::Set(kTerms, corner[first][i]); };
  return {term(0), term(1), term(2), term(3)};
#else
  // Two terms of a corner lie together; with four lanes, those of the next corner but one are behind them.
  const auto two_terms = [&](std::size_t i, std::size_t term) HWY_ATTR {
    const hn::CappedTag<double, 2> two;
#if HWY_MAX_BYTES >= 32
    return hn::Combine(kTerms, hn::LoadU(two, corner[i + 2] + term), hn::LoadU(two, corner[i] + term));
#else
    return hn::LoadU(two, corner[first + i] + term);
#endif
  };
  const TermsVector a = two_terms(0, 0), b = two_terms(1, 0), c = two_terms(0, 2), d = two_terms(1, 2);
  return {hn::InterleaveLower(kTerms, a, b), hn::InterleaveUpper(kTerms, a, b), hn::InterleaveLower(kTerms, c, d),
          hn::InterleaveUpper(kTerms, c, d)};
#endif
}

/// Values of the near and far side, by corner of a face across z: with x, every second corner is far; with y, the last
/// two are. `first` is the number of the vector's first corner.
HWY_INLINE TermsVector by_x(const double (&sides)[2], [[maybe_unused]] std::size_t first) {
#if HWY_TARGET == HWY_SCALAR
  return hn::Set(kTerms, sides[first % 2]);
#else
  return hn::OddEven(hn::Set(kTerms, sides[1]), hn::Set(kTerms, sides[0]));
#endif
}
HWY_INLINE TermsVector by_y(const double (&sides)[2], [[maybe_unused]] std::size_t first) {
#if HWY_MAX_BYTES >= 32
  return hn::ConcatUpperLower(kTerms, hn::Set(kTerms, sides[1]), hn::Set(kTerms, sides[0]));
#else
  return hn::Set(kTerms, sides[first / 2]);
#endif
}

/// The order of the corners, x first, then y, then z, is part of the value.
HWY_INLINE double sum_in(const NoiseTables& tables, const Cell& cell) {
  double sum = 0;
  for (std::size_t dz = 0; dz < 2; ++dz) {
    const double* corners[4];
    for (std::size_t i = 0; i < 4; ++i) corners[i] = tables.slopes.data()[cell.corners[i + 4 * dz]].data();
    for (std::size_t first = 0; first < 4; first += kLanes) {
      const Slopes slope = slopes_of(corners, first);
      const TermsVector value = slope.half_value + slope.x * by_x(cell.from_side[0], first) +
                                slope.y * by_y(cell.from_side[1], first) +
                                slope.z * hn::Set(kTerms, cell.from_side[2][dz]);
      const TermsVector weight =
          by_x(cell.weights[0], first) * by_y(cell.weights[1], first) * hn::Set(kTerms, cell.weights[2][dz]);
      HWY_ALIGN double terms[kLanes];
      hn::Store(weight * value, kTerms, terms);
      for (const double term : terms) sum += term;
    }
  }
  return sum;
}

double lattice_sum(const NoiseTables& tables, const Vec3& p) { return sum_in(tables, cell_around(tables, p)); }

void lattice_octaves(const NoiseTables& tables, const Vec3& p, double scale, double lambda, std::span<double> sums) {
  Cells cells;
  for (std::size_t first = 0; first < sums.size(); first += Cells::kMost) {
    const std::size_t count = std::min(sums.size() - first, Cells::kMost);
    cells.set(tables, p, lambda, count, scale);
    for (std::size_t i = 0; i < count; ++i) sums[first + i] = sum_in(tables, cells.of[i]);
  }
}

/// Three sums and a zero, or as many at a time as there are lanes.
constexpr std::size_t kParts = 4 / kLanes;

/// Adds the sums of a cell, times a weight.
HWY_INLINE void add_vector_sums(const NoiseTables& tables, const Cell& cell, double octave_weight,
                                TermsVector (&all)[kParts]) {
  TermsVector sums[kParts];
  for (TermsVector& sum : sums) sum = hn::Zero(kTerms);
  for (std::size_t i = 0; i < 8; ++i) {
    const std::size_t dx = i % 2, dy = i / 2 % 2, dz = i / 4;
    const NoiseTables::VectorSlope& slope = tables.vector_slopes.data()[cell.corners[i]];
    const TermsVector weight = hn::Set(kTerms, cell.weights[0][dx] * cell.weights[1][dy] * cell.weights[2][dz]);
    for (std::size_t part = 0; part < kParts; ++part) {
      const auto term = [&](std::size_t k) HWY_ATTR { return hn::Load(kTerms, slope[k].data() + part * kLanes); };
      sums[part] += weight * (term(0) + term(1) * hn::Set(kTerms, cell.from_side[0][dx]) +
                              term(2) * hn::Set(kTerms, cell.from_side[1][dy]) +
                              term(3) * hn::Set(kTerms, cell.from_side[2][dz]));
    }
  }
  for (std::size_t part = 0; part < kParts; ++part) all[part] += sums[part] * hn::Set(kTerms, octave_weight);
}

Vec3 lattice_vector_sum(const NoiseTables& tables, const Vec3& p, const Octaves& octaves) {
  TermsVector all[kParts];
  for (TermsVector& sum : all) sum = hn::Zero(kTerms);
  if (octaves.count <= 1) {  // the first octave is there always
    add_vector_sums(tables, cell_around(tables, p), 1, all);
  } else {
    Cells cells;
    double scale = 1, weight = 1;
    auto left = static_cast<std::size_t>(octaves.count);
    while (left > 0) {
      const std::size_t count = std::min(left, Cells::kMost);
      cells.set(tables, p, octaves.lambda, count, scale);
      for (std::size_t i = 0; i < count; ++i, weight *= octaves.omega)
        add_vector_sums(tables, cells.of[i], weight, all);
      left -= count;
    }
  }
  HWY_ALIGN double result[4];
  for (std::size_t part = 0; part < kParts; ++part) hn::Store(all[part], kTerms, result + part * kLanes);
  return {result[0], result[1], result[2]};
}

const LatticeSums* lattice_sums() {
  static constexpr LatticeSums kSums{lattice_sum, lattice_octaves, lattice_vector_sum};
  return &kSums;
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::values
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "renderer/simd/vector_targets.h"

namespace isl::values {
namespace {

using render::entry_points_of;
using render::VectorTarget;

/// The tables, and the functions for the widest vectors of this machine.
struct Lattice {
  const NoiseTables& tables = noise_tables();
  const LatticeSums& sums = *entry_points_of<LatticeSums>(kTargets, "");
  static constexpr VectorTarget<LatticeSums> kTargets[] = {ISL_VECTOR_TARGETS(lattice_sums)};
};

const Lattice& lattice() {
  static const Lattice instance;
  return instance;
}

}  // namespace

double lattice_sum(const scene::Vec3& p) noexcept { return lattice().sums.sum(lattice().tables, p); }

void lattice_octaves(const scene::Vec3& p, double scale, double lambda, std::span<double> sums) noexcept {
  lattice().sums.octaves(lattice().tables, p, scale, lambda, sums);
}

scene::Vec3 lattice_vector_sum(const scene::Vec3& p, const Octaves& octaves) noexcept {
  return lattice().sums.vector_sum(lattice().tables, p, octaves);
}

}  // namespace isl::values
#endif
