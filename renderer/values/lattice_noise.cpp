// This file is compiled once for each vector width (Highway's foreach_target includes it again). Terms are computed
// side by side and added one after the other, so that every width gives the same digits.
#include "renderer/values/lattice_noise.h"

#include "renderer/values/integer.h"
#include "renderer/values/noise_tables.h"

#include <algorithm>
#include <array>
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

/// The numbers of the lattice points at the corners of a cell: x first, then y, then z. (x, y, z) is the near corner.
HWY_INLINE void find_corners(const NoiseTables& tables, std::int32_t x, std::int32_t y, std::int32_t z,
                             std::uint16_t* corners) {
  constexpr std::uint32_t kMask = NoiseTables::kHashes - 1;
  const std::uint16_t* const hash = tables.hash.data();
  const std::uint16_t* const point = tables.point.data();
  const auto both_sides = [](std::int32_t near) {
    const std::uint32_t at = static_cast<std::uint32_t>(near) + kLatticeOrigin;
    return std::array<std::uint32_t, 2>{at & kMask, (at + 1) & kMask};
  };
  const auto xs = both_sides(x), ys = both_sides(y), zs = both_sides(z);
  const std::uint32_t of_x[2] = {hash[xs[0]], hash[xs[1]]};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::uint32_t of_xy = hash[of_x[i % 2] ^ ys[i / 2]];
    corners[i] = point[of_xy ^ zs[0]];
    corners[i + 4] = point[of_xy ^ zs[1]];
  }
}

/// The lattice cell around a point. For one point this takes less time than Cells below.
struct Cell {
  double from_side[3][2];  ///< by axis and by side, the near one first; in edges of the cell
  double weights[3][2];
  std::uint16_t corners[8];

  [[nodiscard]] HWY_INLINE double from(int axis, std::size_t side) const { return from_side[axis][side]; }
  [[nodiscard]] HWY_INLINE double weight(int axis, std::size_t side) const { return weights[axis][side]; }
  [[nodiscard]] HWY_INLINE std::uint16_t corner(std::size_t number) const { return corners[number]; }
};

HWY_INLINE Cell cell_around(const NoiseTables& tables, const Vec3& p) {
  Cell cell;
  std::int32_t lattice[3];
  for (int i = 0; i < 3; ++i) {
    const double below = std::floor(p[i]);
    const double t = std::isfinite(p[i]) ? p[i] - below + 0.0 : 0.0;  // the sum makes 0 of −0
    lattice[i] = to_integer(below);
    cell.from_side[i][0] = t;
    cell.from_side[i][1] = t - 1;
    cell.weights[i][1] = t * t * (3 - 2 * t);
    cell.weights[i][0] = 1 - cell.weights[i][1];
  }
  find_corners(tables, lattice[0], lattice[1], lattice[2], cell.corners);
  return cell;
}

/// The cells of some octaves around their points, side by side. They are found before the sums, so that no octave waits
/// for the one before it.
struct Cells {
  static constexpr std::size_t kMost = 8;
  HWY_ALIGN double from_side[3][2][kMost];
  HWY_ALIGN double weights[3][2][kMost];
  std::uint16_t corners[kMost][8];

  /// One of them, as Cell has it.
  struct Octave {
    const Cells& cells;
    std::size_t octave;
    [[nodiscard]] HWY_INLINE double from(int axis, std::size_t side) const {
      return cells.from_side[axis][side][octave];
    }
    [[nodiscard]] HWY_INLINE double weight(int axis, std::size_t side) const {
      return cells.weights[axis][side][octave];
    }
    [[nodiscard]] HWY_INLINE std::uint16_t corner(std::size_t number) const { return cells.corners[octave][number]; }
  };
  [[nodiscard]] HWY_INLINE Octave operator[](std::size_t octave) const { return {*this, octave}; }
};

/// The scales of the next octaves, and in `scale` that of the one after them. They are put together in registers: a
/// vector that is read from where its numbers have just been written waits until they are in the cache.
HWY_INLINE TermsVector next_scales(double lambda, double& scale) {
  double scales[kLanes];
  for (double& its : scales) {
    its = scale;
    scale *= lambda;
  }
#if HWY_TARGET == HWY_SCALAR
  return hn::Set(kTerms, scales[0]);
#else
  const hn::CappedTag<double, 2> two;
  const auto pair = [&](std::size_t i) HWY_ATTR {
    return hn::InterleaveLower(two, hn::Set(two, scales[i]), hn::Set(two, scales[i + 1]));
  };
#if HWY_MAX_BYTES >= 32
  return hn::Combine(kTerms, pair(2), pair(0));
#else
  return pair(0);
#endif
#endif
}

/// Sets the cells of the first `count` octaves, where `scale` is that of the first, and becomes that of some octave
/// after them.
HWY_INLINE void set_cells(const NoiseTables& tables, const Vec3& p, double lambda, std::size_t count, double& scale,
                          Cells& cells) {
  const hn::Rebind<std::int32_t, Terms> integers;
  HWY_ALIGN std::int32_t lattice[3][Cells::kMost];
  const TermsVector one = hn::Set(kTerms, 1.0), two = hn::Set(kTerms, 2.0), three = hn::Set(kTerms, 3.0);
  for (std::size_t first = 0; first < count; first += kLanes) {
    const TermsVector scales = next_scales(lambda, scale);
    for (int axis = 0; axis < 3; ++axis) {
      const TermsVector at = hn::Set(kTerms, p[axis]) * scales, below = hn::Floor(at);
      const TermsVector difference = at - below + hn::Zero(kTerms);
      // Not a number where the point is infinite: as above, it lies on a corner.
      const TermsVector t = hn::IfThenElseZero(hn::Eq(difference, difference), difference);
      const TermsVector far_weight = t * t * (three - two * t);
      hn::Store(t, kTerms, cells.from_side[axis][0] + first);
      hn::Store(t - one, kTerms, cells.from_side[axis][1] + first);
      hn::Store(one - far_weight, kTerms, cells.weights[axis][0] + first);
      hn::Store(far_weight, kTerms, cells.weights[axis][1] + first);
      if (hn::AllTrue(kTerms, hn::Lt(hn::Abs(below), hn::Set(kTerms, 0x1p31)))) [[likely]] {
        hn::Store(hn::DemoteTo(integers, below), integers, lattice[axis] + first);
      } else {
        HWY_ALIGN double large[kLanes];
        hn::Store(below, kTerms, large);
        for (std::size_t i = 0; i < kLanes; ++i) lattice[axis][first + i] = to_integer(large[i]);
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i)
    find_corners(tables, lattice[0][i], lattice[1][i], lattice[2][i], cells.corners[i]);
}

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
HWY_INLINE TermsVector by_x(double near, double far, [[maybe_unused]] std::size_t first) {
#if HWY_TARGET == HWY_SCALAR
  return hn::Set(kTerms, first % 2 == 0 ? near : far);
#else
  return hn::OddEven(hn::Set(kTerms, far), hn::Set(kTerms, near));
#endif
}
HWY_INLINE TermsVector by_y(double near, double far, [[maybe_unused]] std::size_t first) {
#if HWY_MAX_BYTES >= 32
  return hn::ConcatUpperLower(kTerms, hn::Set(kTerms, far), hn::Set(kTerms, near));
#else
  return hn::Set(kTerms, first / 2 == 0 ? near : far);
#endif
}

/// The order of the corners, x first, then y, then z, is part of the value.
template <class AnyCell>
HWY_INLINE double sum_in(const NoiseTables& tables, const AnyCell& cell) {
  double sum = 0;
  for (std::size_t dz = 0; dz < 2; ++dz) {
    const double* corners[4];
    for (std::size_t i = 0; i < 4; ++i) corners[i] = tables.slopes.data()[cell.corner(i + 4 * dz)].data();
    for (std::size_t first = 0; first < 4; first += kLanes) {
      const Slopes slope = slopes_of(corners, first);
      const TermsVector value = slope.half_value + slope.x * by_x(cell.from(0, 0), cell.from(0, 1), first) +
                                slope.y * by_y(cell.from(1, 0), cell.from(1, 1), first) +
                                slope.z * hn::Set(kTerms, cell.from(2, dz));
      const TermsVector weight = by_x(cell.weight(0, 0), cell.weight(0, 1), first) *
                                 by_y(cell.weight(1, 0), cell.weight(1, 1), first) *
                                 hn::Set(kTerms, cell.weight(2, dz));
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
    set_cells(tables, p, lambda, count, scale, cells);
    for (std::size_t i = 0; i < count; ++i) sums[first + i] = sum_in(tables, cells[i]);
  }
}

/// Three sums and a zero, or as many at a time as there are lanes.
constexpr std::size_t kParts = 4 / kLanes;

/// Adds the sums of a cell, times a weight.
template <class AnyCell>
HWY_INLINE void add_vector_sums(const NoiseTables& tables, const AnyCell& cell, double octave_weight,
                                TermsVector (&all)[kParts]) {
  TermsVector sums[kParts];
  for (TermsVector& sum : sums) sum = hn::Zero(kTerms);
  for (std::size_t i = 0; i < 8; ++i) {
    const std::size_t dx = i % 2, dy = i / 2 % 2, dz = i / 4;
    const NoiseTables::VectorSlope& slope = tables.vector_slopes.data()[cell.corner(i)];
    const TermsVector weight = hn::Set(kTerms, cell.weight(0, dx) * cell.weight(1, dy) * cell.weight(2, dz));
    for (std::size_t part = 0; part < kParts; ++part) {
      const auto term = [&](std::size_t k) HWY_ATTR { return hn::Load(kTerms, slope[k].data() + part * kLanes); };
      sums[part] +=
          weight * (term(0) + term(1) * hn::Set(kTerms, cell.from(0, dx)) +
                    term(2) * hn::Set(kTerms, cell.from(1, dy)) + term(3) * hn::Set(kTerms, cell.from(2, dz)));
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
      set_cells(tables, p, octaves.lambda, count, scale, cells);
      for (std::size_t i = 0; i < count; ++i, weight *= octaves.omega) add_vector_sums(tables, cells[i], weight, all);
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
