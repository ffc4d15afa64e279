// A segment convolved with the Cauchy window (McCormack and Sherstyuk 1998, and the window of cauchy_window-inl.h). In
// support radii, over the part [a, b] of the segment within the support, v along its line, P = ε + ρ², Y(v) = P + v²,
// δ = (b − a)/2 and m = (a + b)/2; s = P + ab, and θ the angle of the point (s, 2δ√P), which the part subtends at a
// distance √P from its line. Y(a)Y(b) = s² + 4δ²P, so sin θ cos θ = 2δs√P/(Y(a)Y(b)), and
//   U₂ = ∫Y⁻² dv = 2δ/(YₐY_b) + (θ − sin θ cos θ)/(2P^{3/2})
//   U₃ = ∫Y⁻³ dv = [3U₂ + b/Y_b² − a/Yₐ²]/(4P),  b/Y_b² − a/Yₐ² = 2δ[P² − 2Pab − ab(a² + ab + b²)]/(YₐY_b)²
//   V₃ = ∫vY⁻³ dv = δm(Yₐ + Y_b)/(YₐY_b)²
// where every difference of the two ends has become a multiple of δ, so that short segments lose no digits. Then
//   f = U₂ − 2δ/B² − 2∫(1 − y)/B³,  −∫g′ = 2U₃ − 4δ/B³,  −∫vg′ = 2V₃ − 4δm/B³,  ∫(1 − y)dv = 2δ[1 − ρ² − m² − δ²/3].
// If ε is small and the part subtends a small angle (seen from near its line, beyond its end), U₃ is a small difference
// of great terms. Its rounding error is reported in the `_terms`, not avoided. Next to the border of the support f
// itself is summed instead (cauchy_border-inl.h), since it is a small difference there.
#if defined(ISL_RENDERER_FIELDS_CONVOLUTIONS_SEGMENT_CAUCHY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_CONVOLUTIONS_SEGMENT_CAUCHY_INL_H_
#undef ISL_RENDERER_FIELDS_CONVOLUTIONS_SEGMENT_CAUCHY_INL_H_
#else
#define ISL_RENDERER_FIELDS_CONVOLUTIONS_SEGMENT_CAUCHY_INL_H_
#endif

#include "renderer/fields/convolutions/cauchy_border-inl.h"
#include "renderer/fields/convolutions/cauchy_window-inl.h"
#include "renderer/fields/convolutions/curve_integrals-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

template <class N>
[[nodiscard]] HWY_INLINE SegmentIntegrals<N> integrate(const CauchyWindow& window, const Chord<N>& chord) {
  const N two(2.0), border2(1 / (window.border * window.border)),
      border3(2 / (window.border * window.border * window.border));
  const N &m = chord.middle, &d = chord.half_length;
  const N a = m - d, b = m + d, ab = a * b, length = two * d;
  const N p = N(window.epsilon) + chord.rho2, root = sqrt(p);
  const N ya = p + a * a, yb = p + b * b, inverse = N(1.0) / (ya * yb);
  const N s = p + ab, angle = angle_of(s, length * root);
  const N u2 = length * inverse + turn_excess(angle, length * s * root * inverse) / (two * p * root);
  const N difference = length * inverse * inverse * (p * p - two * p * ab - ab * (a * a + ab + b * b));
  const N u3_scale = N(0.25) / p;
  const N u3 = u3_scale * (N(3.0) * u2 + difference);
  const N v3 = d * m * (ya + yb) * inverse * inverse;
  const N window1 = length * (N(1.0) - chord.rho2 - m * m - d * d * N(1.0 / 3));

  SegmentIntegrals<N> result;
  result.value = u2 - length * border2 - border3 * window1;
  result.across = two * (u3 - border3 * d);
  result.along = two * (v3 - border3 * d * m);
  result.value_terms = u2 + length * border2 + border3 * (window1 + length);
  if (window.is_steep) {
    const N beyond = max(N(0.0), abs(m) - d), depth = N(1.0) - chord.rho2 - beyond * beyond;  // the greatest
    const auto shallow = (N(0.0) < d) & (N(0.0) < depth) & (depth < N(kShallow * window.border));
    if (!none(shallow)) {
      result.value = select(shallow, integral_at_border(window, chord.rho2, m, d), result.value);
      // Rounding of ρ² and of the ends moves f by half its slopes.
      result.value_terms = select(shallow, result.value + abs(result.across) + abs(result.along), result.value_terms);
    }
  }
  result.across_terms = two * (u3_scale * (N(3.0) * u2 + abs(difference)) + border3 * d);
  result.along_terms = two * (abs(v3) + border3 * abs(d * m));
  return result;
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
