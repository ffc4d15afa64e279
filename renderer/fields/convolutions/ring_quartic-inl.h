// A ring convolved with the quartic window. In support radii, d² the squared distance of the point from the ring of
// radius R, a = 2Rρ and S = 1 − d²: 1 − y = S − a(1 − cos φ), positive for |φ| < μ, where S = a(1 − cos μ) (μ = π if
// the whole ring is within the support). With K = ∫(1 − y)cos φ dφ/a, which stays finite on the axis,
//   cut at μ:   f = Ra²[μ(1 + 2cos²μ) − 3 sin μ cos μ],  ∫(1 − y)dφ = 2a[sin μ − μ cos μ],  K = μ − sin μ cos μ
//   whole:      f = 2πR[(S − a)² + a²/2],                ∫(1 − y)dφ = 2π(S − a),            K = π.
// A large ring has a small μ, whose powers arc_math-inl.h divides out.
//
// Gradient: ∇y = 2(p − s), so with the vectors of RingIntegrals −∫g′ = 2R∫(1 − y)dφ for p, and for ρ⃗ 4R³K.
// Rounding: the error of S is one unit in the last place of R.
#if defined(ISL_RENDERER_FIELDS_CONVOLUTIONS_RING_QUARTIC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_CONVOLUTIONS_RING_QUARTIC_INL_H_
#undef ISL_RENDERER_FIELDS_CONVOLUTIONS_RING_QUARTIC_INL_H_
#else
#define ISL_RENDERER_FIELDS_CONVOLUTIONS_RING_QUARTIC_INL_H_
#endif

#include "renderer/fields/convolutions/curve_integrals-inl.h"
#include "renderer/fields/convolutions/quartic_window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

template <class N>
[[nodiscard]] HWY_INLINE RingIntegrals<N> integrate(const QuarticWindow&, const RingView<N>& view) {
  const N two(2.0);
  const N& r = view.ring_radius;
  const N a = two * r * view.rho, s = N(1.0) - view.distance2;
  const RingArc<N> arc = arc_of(s, a);
  const auto is_whole = s >= two * a;
  const N level = s - a;
  const N plain = select(is_whole, N(2 * kPi) * level, two * a * sine_excess(arc.angle, arc.sine, arc.cosine));
  const N k = select(is_whole, N(kPi), turn_excess(arc.angle, arc.sine * arc.cosine));

  RingIntegrals<N> result;
  result.value = r * select(is_whole, N(2 * kPi) * (level * level + N(0.5) * a * a),
                            a * a * bell_excess(arc.angle, arc.sine, arc.cosine));
  result.whole = two * r * plain;
  result.radial = N(4.0) * r * r * r * k;
  result.value_terms = result.value + result.whole * (N(1.0) + r);
  result.whole_terms = result.whole + N(4.0) * r * arc.angle * (N(1.0) + r);
  result.radial_terms = result.radial;
  return result;
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
