// Octets read back from LaneMemory: quadratics v = v₀ + κ(t − t₀)², of points and of the pieces of other skeletons,
// and the lanes of ray forms and of convolved curves.
#if defined(ISL_RENDERER_FIELDS_RAY_LANE_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_RAY_LANE_ROWS_INL_H_
#undef ISL_RENDERER_FIELDS_RAY_LANE_ROWS_INL_H_
#else
#define ISL_RENDERER_FIELDS_RAY_LANE_ROWS_INL_H_
#endif

#include "renderer/fields/convolutions/windows-inl.h"
#include "renderer/fields/ray/lane_memory.h"
#include "renderer/fields/skeletons/ray_forms-inl.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

static_assert(LaneRow::kLanes == kOctet);

struct QuadraticLanes {
  static constexpr std::size_t kAlong = 3, kShape = 0;
  Octet v0, kappa, middle;
  Octet amplitude;
};

template <class Form, std::size_t... kA, std::size_t... kS>
[[nodiscard]] HWY_INLINE Form load_columns(const LaneRow& row, std::index_sequence<kA...>, std::index_sequence<kS...>) {
  static_assert(sizeof...(kA) <= LaneRow::kMostAlong && sizeof...(kS) <= LaneRow::kMostShape);
  return {load(row.along[kA])..., load(row.shape[kS])..., load(row.amplitude)};
}
template <class Form>
[[nodiscard]] HWY_INLINE Form load_lanes(const LaneRow& row) {
  return load_columns<Form>(row, std::make_index_sequence<Form::kAlong>(), std::make_index_sequence<Form::kShape>());
}

/// A bound of the rounding errors of positions, in units of the greatest coordinate that they are computed from: some
/// eight operations, each off by half a unit in the last place.
inline constexpr double kPositionError = 4 * 0x1p-52;

/// A kernel whose slope by the distance has a bound for all distances.
template <class Kernel>
concept NowhereSteep = requires {
  Kernel::kSteepest;
};

/// A form that counts t from `start`, where the ray is nearest to the component's middle: there a component that is
/// small and far from where the ray starts has small coordinates, which are known to more digits. `size` is the
/// greatest coordinate from there on (for a curve, in support radii).
template <class Form>
struct PlacedLanes : Form {
  Octet start, size;

  // These functions exist for ray forms of skeletons only.
  [[nodiscard]] HWY_INLINE auto at(const Octet& t, double scale) const { return Form::at(t - start, scale); }
  [[nodiscard]] HWY_INLINE auto second(const Octet& t, double scale) const { return Form::second(t - start, scale); }
  [[nodiscard]] HWY_INLINE auto bounds(const Octet& t0, const Octet& t1, double scale, double support) const {
    return Form::bounds(t0 - start, t1 - start, scale, support);
  }
  /// The least v on a stretch with these bounds, wherever positions are off by their rounding errors.
  template <class Bounds>
  [[nodiscard]] HWY_INLINE Octet least(const Bounds& bounds) const {
    const Octet x = max(Octet(0.0), sqrt(bounds.least) - Octet(kPositionError) * size * sqrt(bounds.factor));
    return x * x;
  }

  // These functions exist for convolved curves only.
  template <class Window>
  [[nodiscard]] HWY_INLINE auto at(const Window& window, const Octet& t) const {
    return Form::at(window, t - start, size + Octet(1.0));
  }
  template <class Window>
  [[nodiscard]] HWY_INLINE Octet most(const Window& window, const Octet& t0, const Octet& t1) const {
    return Form::most(window, t0 - start, t1 - start, Octet(kPositionError) * size);
  }
  template <class Window>
  [[nodiscard]] HWY_INLINE Octet least(const Window& window, const Octet& t0, const Octet& t1) const {
    return Form::least(window, t0 - start, t1 - start, Octet(kPositionError) * size);
  }
  [[nodiscard]] HWY_INLINE auto stretch(const Octet& t0, const Octet& t1) const {
    return Form::stretch(t0 - start, t1 - start);
  }
};

template <class Form>
[[nodiscard]] HWY_INLINE PlacedLanes<Form> load_placed(const LaneRow& row) {
  return {load_lanes<Form>(row), load(row.start), load(row.size)};
}

/// The domain of the quadratics of points. `spread` is the greatest coordinate z that they are computed from, in
/// surface radii, as 3 + z + 2kz², k = kPositionError (lane_values-inl.h); `surface` is v where q = 1.
struct Everywhere {
  Octet spread;
  double surface;

  [[nodiscard]] HWY_INLINE OctetMask holds(const OctetMask& mask, const Octet&) const { return mask; }
};
/// The column of `shape` for the spreads of points, which have no other shape.
inline constexpr std::size_t kPointSpread = 0;
[[nodiscard]] HWY_INLINE Everywhere everywhere(const LaneRow& row, const KernelConstants& kernel) {
  return {load(row.shape[kPointSpread]), kernel.scale};
}
/// The domain of the quadratics of pieces, [begin, end), and the greatest coordinate that they are computed from, as √v
/// at that distance.
struct PieceBorders {
  Octet begin, end, size;

  [[nodiscard]] HWY_INLINE OctetMask holds(const OctetMask& mask, const Octet& t) const {
    return mask & (t >= begin) & (t < end);
  }
};
inline constexpr std::size_t kPieceBegin = QuadraticLanes::kAlong, kPieceEnd = kPieceBegin + 1;
[[nodiscard]] HWY_INLINE PieceBorders borders_of(const LaneRow& row) {
  return {load(row.along[kPieceBegin]), load(row.along[kPieceEnd]), load(row.size)};
}

/// The spread of a point whose greatest coordinate is z surface radii.
template <class N>
[[nodiscard]] HWY_INLINE N spread_of(const N& z) {
  return N(3.0) + z * (N(1.0) + N(2 * kPositionError) * z);
}

/// The error of a quadratic's √v at its middle.
[[nodiscard]] HWY_INLINE Octet error_of(const PieceBorders& piece) { return Octet(kPositionError) * piece.size; }
[[nodiscard]] HWY_INLINE Octet error_of(const Everywhere& point) {
  return Octet(kPositionError * std::sqrt(point.surface)) * point.spread;
}

/// The part of an interval inside the domain of a quadratic.
struct HeldPart {
  Octet from, to;
  OctetMask whole;  ///< the part is the whole interval
};
[[nodiscard]] HWY_INLINE HeldPart held_part(const Everywhere&, const Octet& t0, const Octet& t1) {
  return {t0, t1, all_lanes()};
}
[[nodiscard]] HWY_INLINE HeldPart held_part(const PieceBorders& piece, const Octet& t0, const Octet& t1) {
  return {max(t0, piece.begin), min(t1, piece.end), (piece.begin <= t0) & (t1 <= piece.end)};
}
/// The least v on a part, wherever positions are off by their rounding errors.
[[nodiscard]] HWY_INLINE Octet least(const QuadraticLanes& lane, const PieceBorders& piece, const HeldPart& part) {
  const Octet near = max(Octet(0.0), max(part.from - lane.middle, lane.middle - part.to));
  const Octet x = max(Octet(0.0), sqrt(lane.v0 + lane.kappa * near * near) - error_of(piece));
  return x * x;
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
