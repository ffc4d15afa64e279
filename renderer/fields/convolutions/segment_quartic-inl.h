// A segment convolved with the quartic window (Sherstyuk 1999, polynomial kernels along line segments). In support
// radii, at a point ρ from the segment's line, v along the line from the point's foot, A = 1 − ρ²:
//
//   f = ∫ (A − v²)² dv over the part [a, b] of the segment within the support, |v| < √A.
//
// Let m be the middle of [a, b], δ half its length, and B = A − m². Odd powers of v − m cancel exactly, so that short
// segments lose no digits, and
//   f = 2δ[B² + (4m² − 2B)δ²/3 + δ⁴/5],  ∫(A − v²) = 2δ[B − δ²/3],  ∫v(A − v²) = 2δm[B − δ²].
// Cut at both sides m = 0 and δ² = A: f = (16/15)A^{5/2}, which is why an infinite line behaves as the power 5/2.
//
// Gradient: ∇(A − v²) = −2(p − s), and the ends of the part add nothing, since the window vanishes there.
// Rounding: the error of A is one unit in the last place of 1, which ∂f/∂A = 2∫(A − v²) multiplies.
#if defined(ISL_RENDERER_FIELDS_CONVOLUTIONS_SEGMENT_QUARTIC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_CONVOLUTIONS_SEGMENT_QUARTIC_INL_H_
#undef ISL_RENDERER_FIELDS_CONVOLUTIONS_SEGMENT_QUARTIC_INL_H_
#else
#define ISL_RENDERER_FIELDS_CONVOLUTIONS_SEGMENT_QUARTIC_INL_H_
#endif

#include "renderer/fields/convolutions/curve_integrals-inl.h"
#include "renderer/fields/convolutions/quartic_window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

template <class N>
[[nodiscard]] HWY_INLINE SegmentIntegrals<N> integrate(const QuarticWindow&, const Chord<N>& chord) {
  const N two(2.0), third(1.0 / 3);
  const N &m = chord.middle, &d = chord.half_length;
  const N mm = m * m, dd = d * d, length = two * d;
  const N b = N(1.0) - chord.rho2 - mm;
  const N plain = two * length * (b - dd * third);  // −∫g′
  SegmentIntegrals<N> result;
  result.value = length * (b * b + dd * ((N(4.0) * mm - two * b) * third + dd * N(0.2)));
  result.across = plain;
  result.along = two * length * m * (b - dd);
  result.value_terms = result.value + plain;
  result.across_terms = plain + two * length;
  result.along_terms = abs(result.along) + two * length * abs(m);
  return result;
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
