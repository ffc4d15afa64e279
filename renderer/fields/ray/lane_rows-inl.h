// Octets read back from FieldMemory: quadratics v = v₀ + κ(t − t₀)², of points and of the pieces of other skeletons,
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
#include <cstddef>
#include <cstdint>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

static_assert(LaneRow<InLanes::fields>::kLanes == kOctet);

struct QuadraticLanes {
  static constexpr std::size_t kAlong = 3, kShape = 0;
  Octet v0, kappa, middle;
  Octet amplitude;
};

/// Loads a member that depends on the field alone: one number for each lane, or one for all.
[[nodiscard]] HWY_INLINE Octet of_fields(const double (&x)[kOctet]) { return load(x); }
[[nodiscard]] HWY_INLINE Octet of_fields(const double (&x)[1]) { return Octet(x[0]); }

template <class Form, InLanes kWhat, std::size_t... kA, std::size_t... kS>
[[nodiscard]] HWY_INLINE Form load_columns(const LaneRow<kWhat>& row, std::index_sequence<kA...>,
                                           std::index_sequence<kS...>) {
  static_assert(sizeof...(kA) <= LaneRow<kWhat>::kMostAlong && sizeof...(kS) <= LaneRow<kWhat>::kMostShape);
  return {load(row.along[kA])..., of_fields(row.shape[kS])..., of_fields(row.amplitude)};
}
template <class Form, InLanes kWhat>
[[nodiscard]] HWY_INLINE Form load_lanes(const LaneRow<kWhat>& row) {
  return load_columns<Form>(row, std::make_index_sequence<Form::kAlong>(), std::make_index_sequence<Form::kShape>());
}

/// The domain of the quadratics of points.
struct Everywhere {
  [[nodiscard]] HWY_INLINE OctetMask holds(const OctetMask& mask, const Octet&) const { return mask; }
};
/// The domain of the quadratics of pieces, [begin, end).
struct PieceBorders {
  Octet begin, end;

  [[nodiscard]] HWY_INLINE OctetMask holds(const OctetMask& mask, const Octet& t) const {
    return mask & (t >= begin) & (t < end);
  }
};
inline constexpr std::size_t kPieceBegin = QuadraticLanes::kAlong, kPieceEnd = kPieceBegin + 1;
template <InLanes kWhat>
[[nodiscard]] HWY_INLINE PieceBorders borders_of(const LaneRow<kWhat>& row) {
  return {load(row.along[kPieceBegin]), load(row.along[kPieceEnd])};
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

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
