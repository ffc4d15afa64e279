// Bounds of the error of a cubic Hermite interpolant of a convolved curve's field, along a stretch of a ray of width h.
//
// f = ∫ g ds over the part of the curve within the support. Where the part ends at the support's border (is cut), the
// end moves: with W = |(p − s)·τ| there (τ the curve's tangent) and e = (p − s)·D it moves along the curve at the speed
// e/W. This adds nothing to the second derivative, since g = g′ = 0 there, and with γ = g″(1)
//   to f‴   −4γe³/W,
//   to f⁗   −[24γe²D² + 16γe³(τ·D)/W + 8g‴(1)e⁴ + 4γκe⁴/W²]/W,
// κ = 1 on a straight curve and ρ cos μ/R on a ring (its curvature turns τ). So f‴ jumps where the end of a segment
// enters the support, f⁗ grows as W⁻³, and neither is bounded where W vanishes: at the border of the whole field. Hence
// there are three bounds, of which the least is used (the integrals of Peano's kernel of the interpolant's error, and
// of its derivative):
//   smooth (no end enters or leaves the support): E = h⁴ max|f⁗|/384,   E′ = (√3/216)h³ max|f⁗|
//   W > 0:                                        E = h³ osc f‴/192,    E′ = 0.0162 h² osc f‴
//   always:                                       E = h² osc f″/32,     E′ = 0.126 h osc f″.
// The second: E ≤ max_t ∫|∂K/∂s|ds · osc f‴/2, K(t, s) the interpolant's Green's function, whose greatest value is
// h³/192; for E′ that of ∂K/∂t, which is h² max t(2 − 3t)³/(54(1 − t)²) < 0.0162 h² (at t = 0.2325).
#if defined(ISL_RENDERER_FIELDS_CONVOLUTIONS_CURVE_REMAINDER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_CONVOLUTIONS_CURVE_REMAINDER_INL_H_
#undef ISL_RENDERER_FIELDS_CONVOLUTIONS_CURVE_REMAINDER_INL_H_
#else
#define ISL_RENDERER_FIELDS_CONVOLUTIONS_CURVE_REMAINDER_INL_H_
#endif

#include "renderer/fields/convolutions/window_bounds-inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// An end of the part of a curve within the support.
struct CutBounds {
  OctetMask may_be;     ///< the support cuts the curve on this side at some t of the stretch
  OctetMask stays;      ///< it does so at all t of the stretch, or at none
  Octet width2;         ///< lower bound of W²; 0 or less if W may vanish
  Octet e_low, e_high;  ///< range of e
  Octet bend;           ///< greatest |κ|
};

/// A curve as a stretch of a ray sees it, lengths in support radii.
struct CurveStretch {
  Octet y_least;  ///< least squared distance; if it is 1 or more the field is zero
  Octet length;   ///< upper bound of the curve's length within the support at any t
  Octet spread;   ///< the distance grows at least as fast as that of a line stretched by this
  Octet e2;       ///< greatest ((p − s)·D)² within the support
  Octet speed2;   ///< |D|²
  Octet tangent;  ///< greatest |τ·D|
  CutBounds cuts[2];
};

struct CurveRemainder {
  Octet value, slope;
};

/// Bounds of the interpolant's error for a field of amplitude 1.
template <class Window>
[[nodiscard]] HWY_INLINE CurveRemainder curve_remainder(const Window& window, const CurveStretch& c, const Octet& h) {
  const Octet zero(0.0), infinite(std::numeric_limits<double>::infinity());
  const Octet second_at(window.second_at_border()), third_at(window.third_at_border());
  const WindowBounds b = window.bounds(c.y_least, c.e2, c.speed2);
  const Octet length = window.effective_length(c.length, c.y_least, c.spread);
  const Octet second = length * (b.second_high - b.second_low);
  Octet third = Octet(2.0) * length * b.third, fourth = length * b.fourth;
  for (const CutBounds& cut : c.cuts) {
    const Octet up = max(cut.e_high, zero), down = max(zero - cut.e_low, zero);
    const Octet e = max(up, down), e2 = e * e, e3 = e2 * e;
    const OctetMask has_width = cut.width2 > zero;
    const Octet inverse2 = select(has_width, Octet(1.0) / cut.width2, infinite), inverse = sqrt(inverse2);
    const Octet jump = Octet(4.0) * second_at * (up * up * up + down * down * down) * inverse;
    const Octet bound = inverse * (second_at * (Octet(24.0) * e2 * c.speed2 + Octet(16.0) * e3 * c.tangent * inverse +
                                                Octet(4.0) * cut.bend * e2 * e2 * inverse2) +
                                   Octet(8.0) * third_at * e2 * e2);
    third = third + keep(cut.may_be, select(has_width, jump, infinite));
    fourth = fourth + keep(cut.may_be, select(has_width & cut.stays, bound, infinite));
    fourth = select(cut.stays, fourth, infinite);
  }
  const Octet h2 = h * h, h3 = h * h2;
  const Octet value =
      min(h2 * Octet(1.0 / 32) * second, min(h3 * Octet(1.0 / 192) * third, h2 * h2 * Octet(1.0 / 384) * fourth));
  const Octet slope =
      min(h * Octet(0.126) * second, min(h2 * Octet(0.0162) * third, h3 * Octet(0.00801876) * fourth));  // √3/216
  const OctetMask counts = c.y_least < Octet(1.0);
  return {keep(counts, value), keep(counts, slope)};
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
