// This file is compiled once for each vector width (Highway's foreach_target includes it again). Terms are computed
// side by side and added one after the other, so that every width gives the same digits.
#include "renderer/values/lattice_noise.h"

#include "renderer/values/integer.h"
#include "renderer/values/noise_tables.h"

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

/// The lattice cell around a point. Arrays are by corner, the near one first.
struct Cell {
  double from_corner[3][2];      ///< along each axis, in edges of the cell
  double weight[3][2];           ///< along each axis
  std::uint32_t point_xy[2][2];  ///< hashes, by x and y
  std::uint32_t z[2];            ///< coordinates modulo kHashes
};

HWY_INLINE Cell cell_around(const Vec3& p, const NoiseTables& tables) {
  constexpr std::uint32_t kMask = NoiseTables::kHashes - 1;
  const std::uint16_t* const hash = tables.hash.data();
  Cell cell;
  std::uint32_t at[3];
  for (int i = 0; i < 3; ++i) {
    const double below = std::floor(p[i]);
    const double t = std::isfinite(p[i]) ? p[i] - below + 0.0 : 0.0;  // the sum makes 0 of −0
    cell.from_corner[i][0] = t;
    cell.from_corner[i][1] = t - 1;
    cell.weight[i][1] = t * t * (3 - 2 * t);
    cell.weight[i][0] = 1 - cell.weight[i][1];
    at[i] = static_cast<std::uint32_t>(to_integer(below)) + kLatticeOrigin;
  }
  const std::uint32_t y[2] = {at[1] & kMask, (at[1] + 1) & kMask};
  for (std::uint32_t dx = 0; dx < 2; ++dx) {
    const std::uint32_t of_x = hash[(at[0] + dx) & kMask];
    for (int dy = 0; dy < 2; ++dy) cell.point_xy[dx][dy] = hash[of_x ^ y[dy]];
  }
  for (std::uint32_t dz = 0; dz < 2; ++dz) cell.z[dz] = (at[2] + dz) & kMask;
  return cell;
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

/// Values of the near and far side, by corner: with x, every second corner is far; with y, the last two are.
HWY_INLINE TermsVector by_x(const double (&sides)[2], std::size_t first) {
#if HWY_TARGET == HWY_SCALAR
  return hn::Set(kTerms, sides[first & 1]);
#else
  (void)first;
  return hn::OddEven(hn::Set(kTerms, sides[1]), hn::Set(kTerms, sides[0]));
#endif
}
HWY_INLINE TermsVector by_y(const double (&sides)[2], std::size_t first) {
#if HWY_MAX_BYTES >= 32
  (void)first;
  return hn::ConcatUpperLower(kTerms, hn::Set(kTerms, sides[1]), hn::Set(kTerms, sides[0]));
#else
  return hn::Set(kTerms, sides[first / 2]);
#endif
}

/// The order of the corners, x first, then y, then z, is part of the value.
double lattice_sum(const NoiseTables& tables, const Vec3& p) {
  const Cell cell = cell_around(p, tables);
  double sum = 0;
  for (int dz = 0; dz < 2; ++dz) {
    const auto corner = [&](int dx, int dy) HWY_ATTR {
      return tables.slopes.data()[tables.point.data()[cell.point_xy[dx][dy] ^ cell.z[dz]]].data();
    };
    const double* const corners[4] = {corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)};
    for (std::size_t first = 0; first < 4; first += kLanes) {
      const Slopes slope = slopes_of(corners, first);
      const TermsVector value = slope.half_value + slope.x * by_x(cell.from_corner[0], first) +
                                slope.y * by_y(cell.from_corner[1], first) +
                                slope.z * hn::Set(kTerms, cell.from_corner[2][dz]);
      const TermsVector weight =
          by_x(cell.weight[0], first) * by_y(cell.weight[1], first) * hn::Set(kTerms, cell.weight[2][dz]);
      HWY_ALIGN double terms[kLanes];
      hn::Store(weight * value, kTerms, terms);
      for (const double term : terms) sum += term;
    }
  }
  return sum;
}

/// Three sums and a zero, or as many at a time as there are lanes.
constexpr std::size_t kParts = 4 / kLanes;

HWY_INLINE void add_vector_sums(const NoiseTables& tables, const Vec3& p, TermsVector (&sums)[kParts]) {
  const Cell cell = cell_around(p, tables);
  for (int dz = 0; dz < 2; ++dz) {
    for (int dy = 0; dy < 2; ++dy) {
      for (int dx = 0; dx < 2; ++dx) {
        const NoiseTables::VectorSlope& slope =
            tables.vector_slopes.data()[tables.point.data()[cell.point_xy[dx][dy] ^ cell.z[dz]]];
        const TermsVector weight = hn::Set(kTerms, cell.weight[0][dx] * cell.weight[1][dy] * cell.weight[2][dz]);
        for (std::size_t part = 0; part < kParts; ++part) {
          const auto term = [&](std::size_t i) HWY_ATTR { return hn::Load(kTerms, slope[i].data() + part * kLanes); };
          sums[part] += weight * (term(0) + term(1) * hn::Set(kTerms, cell.from_corner[0][dx]) +
                                  term(2) * hn::Set(kTerms, cell.from_corner[1][dy]) +
                                  term(3) * hn::Set(kTerms, cell.from_corner[2][dz]));
        }
      }
    }
  }
}

Vec3 lattice_vector_sum(const NoiseTables& tables, const Vec3& p, const Octaves& octaves) {
  TermsVector all[kParts];
  for (TermsVector& sum : all) sum = hn::Zero(kTerms);
  add_vector_sums(tables, p, all);  // the first octave is there always, with weight 1
  double scale = octaves.lambda, weight = octaves.omega;
  for (int i = 1; i < octaves.count; ++i) {
    TermsVector sums[kParts];
    for (TermsVector& sum : sums) sum = hn::Zero(kTerms);
    add_vector_sums(tables, p * scale, sums);
    for (std::size_t part = 0; part < kParts; ++part) all[part] += sums[part] * hn::Set(kTerms, weight);
    scale *= octaves.lambda;
    weight *= octaves.omega;
  }
  HWY_ALIGN double result[4];
  for (std::size_t part = 0; part < kParts; ++part) hn::Store(all[part], kTerms, result + part * kLanes);
  return {result[0], result[1], result[2]};
}

const LatticeSums* lattice_sums() {
  static constexpr LatticeSums kSums{lattice_sum, lattice_vector_sum};
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

scene::Vec3 lattice_vector_sum(const scene::Vec3& p, const Octaves& octaves) noexcept {
  return lattice().sums.vector_sum(lattice().tables, p, octaves);
}

}  // namespace isl::values
#endif
