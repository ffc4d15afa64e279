// A ring convolved with the Cauchy window (McCormack and Sherstyuk 1998, and the window of cauchy_window-inl.h). In
// support radii, d² the squared distance of the point from the ring of radius R, a = 2Rρ: Y = Y₀ + a(1 − cos φ) with
// Y₀ = ε + d²; C = Y₀ + a, Δ = C² − a² = Y₀(Y₀ + 2a), and Eₙ = ∫Y⁻ⁿ dφ over the part |φ| < μ within the support, where
// Y(μ) = B:
//   E₁ = (4/√Δ) atan(√((Y₀ + 2a)/Y₀) tan(μ/2))
//   E₂ = [2a sin μ/B + C E₁]/Δ                          (whole: 2πC/Δ^{3/2})
//   E₃ = [2a sin μ/B² + 3C E₂ − E₁]/(2Δ)                (whole: π(2C² + a²)/Δ^{5/2})
//   K = ∫cos φ Y⁻³dφ/a = (C E₃ − E₂)/a²                 (whole: 3πC/Δ^{5/2})
// (the recurrence of ∫dφ/(C − a cos φ)ⁿ). Then with the integrals of 1 − y of ring_quartic-inl.h
//   f = R[E₂ − 2μ/B² − 2∫(1 − y)dφ/B³],
//   for p: R[2E₃ − 4μ/B³],   for ρ⃗: 2R²[2R K − 2 sin μ/(B³ρ)]   (whole: the second term is 0).
// The formulas of a whole ring contain no angle and no division by ρ. Next to the border f is summed instead
// (cauchy_border-inl.h), since these formulas are differences there.
#if defined(ISL_RENDERER_FIELDS_CONVOLUTIONS_RING_CAUCHY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_CONVOLUTIONS_RING_CAUCHY_INL_H_
#undef ISL_RENDERER_FIELDS_CONVOLUTIONS_RING_CAUCHY_INL_H_
#else
#define ISL_RENDERER_FIELDS_CONVOLUTIONS_RING_CAUCHY_INL_H_
#endif

#include "renderer/fields/convolutions/cauchy_border-inl.h"
#include "renderer/fields/convolutions/cauchy_window-inl.h"
#include "renderer/fields/convolutions/curve_integrals-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

template <class N>
[[nodiscard]] HWY_INLINE RingIntegrals<N> integrate(const CauchyWindow& window, const RingView<N>& view) {
  const N one(1.0), two(2.0), least(1e-150);
  const N border1(1 / window.border), border2 = border1 * border1, border3 = border1 * border2;
  const N& r = view.ring_radius;
  const N a = max(two * r * view.rho, least), s = one - view.distance2;
  const RingArc<N> arc = arc_of(s, a);
  const auto is_whole = s >= two * a;
  const N y = N(window.epsilon) + view.distance2, far = y + two * a, c = y + a;
  const N inverse = one / (y * far), root = sqrt(inverse);
  // tan(μ/2) = √(S/(2a − S)).
  const N half_angle = angle_of(sqrt(y * max(two * a - s, N(0.0))), sqrt(far * max(s, N(0.0))));
  const N cut1 = N(4.0) * root * half_angle;
  const N sine = two * a * arc.sine * border1;
  const N cut2 = (sine + c * cut1) * inverse;
  const N e2 = select(is_whole, N(2 * kPi) * c * inverse * root, cut2);
  const N e3_whole = N(kPi) * (two * c * c + a * a) * inverse * inverse * root;
  const N e3_cut = N(0.5) * inverse * (sine * border1 + N(3.0) * c * cut2 - cut1);
  const N e3 = select(is_whole, e3_whole, e3_cut);
  const N inverse_a = one / a;
  const N k = select(is_whole, N(3 * kPi) * c * inverse * inverse * root, (c * e3_cut - cut2) * inverse_a * inverse_a);
  const N plain = select(is_whole, N(2 * kPi) * (s - a), two * a * sine_excess(arc.angle, arc.sine, arc.cosine));
  const N window_radial = N(4.0) * border3 * r * r * arc.sine * (two * r * inverse_a);

  RingIntegrals<N> result;
  result.value = r * (e2 - two * border2 * arc.angle - two * border3 * plain);
  result.whole = r * (two * e3 - N(4.0) * border3 * arc.angle);
  result.radial = N(4.0) * r * r * r * k - window_radial;
  // Y₀ and S have an error of one unit in the last place of R, and E₃ and K of a part are differences.
  const N e3_terms = select(is_whole, e3, inverse * (N(3.0) * c * cut2 + cut1)) + e3 * (one + r) / y;
  result.value_terms = r * (e2 + two * border2 * arc.angle + two * border3 * plain) + (one + r) * r * two * e3;
  if (window.is_steep) {
    const auto shallow = (N(0.0) < s) & (s < N(kShallow * window.border));
    if (!none(shallow)) {
      result.value = select(shallow, r * ring_at_border(window, s, a, arc.angle), result.value);
      result.value_terms = select(shallow, result.value + (one + r) * abs(result.whole), result.value_terms);
    }
  }
  result.whole_terms = r * (two * e3_terms + N(4.0) * border3 * arc.angle);
  result.radial_terms =
      N(4.0) * r * r * r *
          (k * (two + r) / y + select(is_whole, N(0.0), (c * e3_terms + cut2) * inverse_a * inverse_a)) +
      window_radial;
  return result;
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
