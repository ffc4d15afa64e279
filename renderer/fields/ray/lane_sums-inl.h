// The parts of bounds of a cell's sum along an interval of a ray: ranges of eight fields, the part of the interval on a
// piece of a field, and sums of ranges (lane_range-inl.h, lane_slope-inl.h, lane_bend-inl.h).
#if defined(ISL_RENDERER_FIELDS_RAY_LANE_SUMS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_RAY_LANE_SUMS_INL_H_
#undef ISL_RENDERER_FIELDS_RAY_LANE_SUMS_INL_H_
#else
#define ISL_RENDERER_FIELDS_RAY_LANE_SUMS_INL_H_
#endif

#include "renderer/fields/ray/lane_rows-inl.h"

#include <algorithm>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// An interval of a ray, widened by the rounding error of a point's position along it: four half units in the last
/// place of t.
struct WidenedInterval {
  double drift, t0, t1;

  HWY_INLINE WidenedInterval(double from, double to)
      : drift(0x1p-51 * std::max(std::abs(from), std::abs(to))), t0(from - drift), t1(to + drift) {}
};

struct OctetRange {
  Octet low, high;
};

/// The range, or (−∞, ∞) if it is not valid: near the skeleton of very hard kernels the bounds overflow and their
/// products are NaN.
[[nodiscard]] HWY_INLINE OctetRange sound(const OctetRange& r) {
  const Octet infinite(std::numeric_limits<double>::infinity());
  const OctetMask is_range = r.low <= r.high;
  return {select(is_range, r.low, Octet(0.0) - infinite), select(is_range, r.high, infinite)};
}
[[nodiscard]] HWY_INLINE OctetRange with_zero(const OctetMask& keeps, const OctetRange& range) {
  const Octet zero(0.0);
  const OctetRange r = sound(range);
  return {select(keeps, r.low, min(r.low, zero)), select(keeps, r.high, max(r.high, zero))};
}
/// The range times a number of either sign; {0, 0} where not `counts`.
[[nodiscard]] HWY_INLINE OctetRange scaled(const OctetMask& counts, const Octet& amplitude, const OctetRange& range) {
  const OctetRange r = sound(range);
  const Octet one = amplitude * r.low, other = amplitude * r.high;
  return {keep(counts, min(one, other)), keep(counts, max(one, other))};
}

/// The part of an interval that lies on a piece, as t − middle. Both the interval and the piece are uncertain
/// by ± drift: [t0, t1] has been widened by it already, and the piece is widened here.
struct OnPiece {
  Octet a, b;       ///< ends
  OctetMask whole;  ///< the part is the whole interval
  OctetMask any;    ///< the part is not empty

  HWY_INLINE OnPiece(const Everywhere&, const Octet& middle, double t0, double t1, double /*drift*/)
      : OnPiece(Octet(t0), Octet(t1), middle) {
    whole = any;
  }
  HWY_INLINE OnPiece(const PieceBorders& piece, const Octet& middle, double t0, double t1, double drift)
      : OnPiece(max(Octet(t0), piece.begin - Octet(drift)), min(Octet(t1), piece.end + Octet(drift)), middle) {
    whole = (piece.begin <= Octet(t0 + drift)) & (Octet(t1 - drift) <= piece.end);
  }
  [[nodiscard]] HWY_INLINE Octet near() const { return max(Octet(0.0), max(a, Octet(0.0) - b)); }
  [[nodiscard]] HWY_INLINE Octet far() const { return max(abs(a), abs(b)); }

 private:
  HWY_INLINE OnPiece(const Octet& from, const Octet& to, const Octet& middle)
      : a(from - middle), b(to - middle), any(from <= to) {}
};

/// The range of a sum of fields; the threshold is not subtracted.
struct SumRange {
  double low, high;
  double low_terms,
      high_terms;  ///< sums of the absolute values of their terms: the scales of the rounding errors
};

class RangeSums {
 public:
  HWY_INLINE RangeSums() : low_(0.0), high_(0.0), low_terms_(0.0), high_terms_(0.0) {}

  HWY_INLINE void add(const OctetRange& r) {
    low_ = low_ + r.low;
    high_ = high_ + r.high;
    low_terms_ = low_terms_ + abs(r.low);
    high_terms_ = high_terms_ + abs(r.high);
  }
  [[nodiscard]] HWY_INLINE SumRange total() const { return {sum(low_), sum(high_), sum(low_terms_), sum(high_terms_)}; }

 private:
  Octet low_, high_, low_terms_, high_terms_;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
