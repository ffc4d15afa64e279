// The field of a convolved curve at a point: f = ∫ g(|p − s|²) ds over the part of the curve within the support,
// |p − s| < 1 (all lengths in support radii, g a window of quartic_window-inl.h or cauchy_window-inl.h), and the two
// integrals that make its gradient. Each pair of curve and window has a file with their closed forms, templates over
// the type of number (one or eight).
//
// Since g and g′ vanish at the support's border, f is twice differentiable, and ∇f = 2∫g′·(p − s) ds.
#if defined(ISL_RENDERER_FIELDS_CONVOLUTIONS_CURVE_INTEGRALS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_CONVOLUTIONS_CURVE_INTEGRALS_INL_H_
#undef ISL_RENDERER_FIELDS_CONVOLUTIONS_CURVE_INTEGRALS_INL_H_
#else
#define ISL_RENDERER_FIELDS_CONVOLUTIONS_CURVE_INTEGRALS_INL_H_
#endif

#include "renderer/fields/convolutions/arc_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// The part of a segment within the support of a point.
template <class N>
struct Chord {
  N rho2;                 ///< squared distance of the point from the segment's line
  N middle, half_length;  ///< along the line, from the point's foot; half_length ≤ 0 if there is no such part
};

/// `before`: the signed distance from the first end to the point's foot, towards the second end; `behind`: that from
/// the foot to the second end; `half_length`: half the length of the whole segment. Each distance is measured from its
/// own end, so that the other loses no digits if one end is far away.
template <class N>
[[nodiscard]] HWY_INLINE Chord<N> chord_of(const N& rho2, const N& before, const N& behind, const N& half_length) {
  const N reach = sqrt(max(N(1.0) - rho2, N(0.0)));
  const N from = max(N(0.0) - before, N(0.0) - reach), to = min(behind, reach);
  const auto is_whole = (before <= reach) & (behind <= reach);
  return {rho2, N(0.5) * (from + to), select(is_whole, min(half_length, reach), N(0.5) * (to - from))};
}

/// ∇f = −2(ρ⃗ · across − axis · along), ρ⃗ from the line to the point. The `_terms` are the scales of the
/// rounding errors: the sums of the absolute values of the terms.
template <class N>
struct SegmentIntegrals {
  N value, across, along;
  N value_terms, across_terms, along_terms;
};

/// A ring about the z axis as seen from a point.
template <class N>
struct RingView {
  N ring_radius;
  N rho;        ///< distance of the point from the axis
  N distance2;  ///< squared distance from the point to the ring: (ρ − R)² + z²
};

/// ∇f = −2(p · whole − ρ⃗ · radial), p from the ring's centre, ρ⃗ from its axis.
template <class N>
struct RingIntegrals {
  N value, whole, radial;
  N value_terms, whole_terms, radial_terms;
};

/// Half the angle, at the ring's centre, of the part of the ring within the support, with its sine and cosine.
template <class N>
struct RingArc {
  N angle, sine, cosine;  ///< angle = π, 0 and −1 for a whole ring
};

/// |p − s|² = d² + a(1 − cos φ) with a = 2Rρ, so with S = 1 − d² the support ends where sin²(φ/2) = S/2a. S > 0.
template <class N>
[[nodiscard]] HWY_INLINE RingArc<N> arc_of(const N& s, const N& a) {
  const N zero(0.0), rest = N(2.0) * a - s;
  const auto is_whole = rest <= zero;
  const N near = sqrt(max(s, zero)), far = sqrt(max(rest, zero));
  const N inverse = N(1.0) / max(N(2.0) * a, N(1e-300));
  return {select(is_whole, N(kPi), N(2.0) * angle_of(far, near)), select(is_whole, zero, N(2.0) * near * far * inverse),
          select(is_whole, N(-1.0), (rest - s) * inverse)};
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
