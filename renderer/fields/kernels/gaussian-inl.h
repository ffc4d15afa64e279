// The windowed Gaussian (Blinn 1982, less its tangent at the border): φ(v) = e^{a−v} − cut (1 + S − v), v < S,
// S = support.
//
// The window is linear in v, so it changes φ′ by a constant and no higher derivative. Along a ray on which v = v₀ + κτ²
// (point, segment), with y = κτ² and p = e^{a−v₀}:
//   f″ = κ p (4y − 2) e^{−y} + 2κ cut,   f⁗ = κ² p (16y² − 48y + 12) e^{−y}.
// s(y) = (4y − 2)e^{−y} rises to 4e^{−3/2} < 0.8926 at y = 3/2 and falls after it; it is concave for y < 5/2, so that
// −2 + 4y ≤ s(y) on [0, ½] (chord) and s(y) ≤ −2 + 6y (tangent at 0). |16y² − 48y + 12|e^{−y} falls for y > 4.09 (where
// the quadratic's logarithmic slope drops below 1); before that it is bounded by a falling staircase over √y, each step
// the maximum to its right.
//
// Constants: v = aq, S = aQ; the tangent (in q) at the border of the support is subtracted, so that value and slope
// vanish there: cut = e^{−a(Q−1)} = δ, a = h(1 − δ(1 + ln 1/δ))/(1 − δ), Q = 1 + ln(1/δ)/a, amplitude
// 1/(1 − δ(1 + ln 1/δ)).
#if defined(ISL_RENDERER_FIELDS_KERNELS_GAUSSIAN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_KERNELS_GAUSSIAN_INL_H_
#undef ISL_RENDERER_FIELDS_KERNELS_GAUSSIAN_INL_H_
#else
#define ISL_RENDERER_FIELDS_KERNELS_GAUSSIAN_INL_H_
#endif

#include "renderer/fields/kernels/kernel_bounds-inl.h"
#include "renderer/simd/exp-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct Gaussian {
  double a, support_, cut;

  HWY_INLINE explicit Gaussian(const KernelConstants& k) : a(k.a), support_(k.support), cut(k.cut) {}

  /// The Gaussian's value at the border of the support, relative to that at the surface: the tail that is cut off is
  /// below a thousandth of the threshold.
  static constexpr double kCut = 1e-3;

  [[nodiscard]] static KernelConstants constants(double h) {
    const double log_cut = std::log(1 / kCut), kept = 1 - kCut * (1 + log_cut);
    KernelConstants constants;
    constants.a = h * kept / (1 - kCut);
    constants.scale = constants.a;
    constants.support = constants.a + log_cut;
    constants.amplitude = 1 / kept;
    constants.cut = kCut;
    return constants;
  }

  [[nodiscard]] HWY_INLINE Octet support() const { return Octet(support_); }

  /// φ for v within the support.
  template <class N>
  [[nodiscard]] HWY_INLINE N value(const N& v) const {
    return exp(N(a) - v) - N(cut) * (N(1 + support_) - v);
  }
  /// An upper bound of value(), kExpAbove of the exponential above it at most.
  [[nodiscard]] HWY_INLINE Octet most(const Octet& v) const {
    return exp_above(Octet(a) - v) - Octet(cut) * (Octet(1 + support_) - v);
  }
  [[nodiscard]] HWY_INLINE KernelValue value_and_slope(const Octet& v) const {
    const Octet e = exp(Octet(a) - v);
    return {e - Octet(cut) * (Octet(1 + support_) - v), Octet(cut) - e};
  }
  /// φ″(v).
  [[nodiscard]] HWY_INLINE Octet curvature(const Octet& v) const { return exp(Octet(a) - v); }

  [[nodiscard]] HWY_INLINE OctetMask is_smooth(const Octet& v_low, const Octet& v_high) const {
    return v_low <= v_high;
  }

  /// Bounds of f = φ(v₀ + κτ²) for κτ² in [u_near, u_far], within the support.
  [[nodiscard]] HWY_INLINE SecondAndFourth on_quadratic(const Octet& v0, const Octet& kappa, const Octet& u_near,
                                                        const Octet& u_far) const {
    const Octet at_peak = kappa * exp_above(Octet(a) - v0);
    const Octet at_near = kappa * exp_above(Octet(a) - (v0 + u_near));
    const Octet window = Octet(2 * cut) * kappa;
    const Octet low = at_peak * min(Octet(4.0) * u_near - Octet(2.0), Octet(0.0));
    // A negative factor wants the least that e^{a−v₀} may be.
    const Octet factor = min(Octet(0.8926), Octet(6.0) * u_far - Octet(2.0));
    const Octet at_peak_least = Octet(1 - kExpAbove) * at_peak;
    const Octet high = select(u_near > Octet(1.5), at_near * (Octet(4.0) * u_near - Octet(2.0)),
                              max(at_peak * factor, at_peak_least * factor));
    const Octet tail = at_near * ((Octet(16.0) * u_near - Octet(48.0)) * u_near + Octet(12.0));
    return {low + window, high + window, kappa * select(u_near > Octet(4.09), tail, at_peak * profile4(u_near))};
  }

  [[nodiscard]] HWY_INLINE SlopeBounds slopes(const Octet& v_least) const {
    const Octet e = exp(Octet(a) - v_least);
    return {e - Octet(cut), e, e, e};
  }

 private:
  /// max over z ≥ y of |16z² − 48z + 12|e^{−z}, from above.
  [[nodiscard]] static HWY_INLINE Octet profile4(const Octet& y) {
    struct Step {
      double from, bound;
    };
    // Steps at √y = 0.2, 0.3, 1.1, 1.3, 1.5, 2.
    constexpr Step kSteps[] = {{0.04, 9.72}, {0.09, 7.43}, {1.21, 6.77}, {1.69, 4.33}, {2.25, 1.59}, {4.0, 1.40}};
    Octet bound(12.0);
    for (const Step& step : kSteps) bound = select(y >= Octet(step.from), Octet(step.bound), bound);
    return bound;
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
