// The kernel of soft objects (Wyvill, McPheeters and Wyvill 1986): φ(v) = 1 − 22/9 v + 17/9 v² − 4/9 v³, v < 1, which
// is (1 − v)²(1 − 4/9 v). Amplitude and sign are left out.
//
//   φ′ = −(2/9)(1 − v)(11 − 6v),   φ″ = (34 − 24v)/9,   φ‴ = −24/9;   φ is convex, |φ′| and φ″ fall on [0, 1].
//
// Along a ray on which v = v₀ + κτ² (point, segment), with u = κτ²:
//   f″ = 2κ(φ′(v) + 2uφ″(v)), a concave quadratic of u with its top at u = (102 − 72v₀)/120,
//   f⁗ = κ²(12φ″ + 48uφ‴) = κ²(12(34 − 24v₀) − 1440u)/9, linear in u.
//
// Constants: v = xq with −xφ′(x)/φ(x) = h, that is 2x(11 − 6x) = h(1 − x)(9 − 4x), and amplitude 1/φ(x). With y = 1 − x
// the condition is (12 + 4h)y² + (5h − 2)y − 10 = 0; y has all its digits only from there.
#if defined(ISL_RENDERER_FIELDS_KERNELS_SOFT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_KERNELS_SOFT_INL_H_
#undef ISL_RENDERER_FIELDS_KERNELS_SOFT_INL_H_
#else
#define ISL_RENDERER_FIELDS_KERNELS_SOFT_INL_H_
#endif

#include "renderer/fields/kernels/kernel_bounds-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct Soft {
  HWY_INLINE explicit Soft(const KernelConstants&) {}

  [[nodiscard]] static KernelConstants constants(double h) {
    // (4h + 12)x² − (13h + 22)x + 9h = 0; the lesser root, in the form without cancellation.
    const double half = 0.5 * (13 * h + 22);
    const double x = 9 * h / (half + std::sqrt(half * half - 9 * h * (4 * h + 12)));
    const double y = 20 / (5 * h - 2 + std::sqrt((5 * h + 14) * (5 * h + 14) + 288));
    KernelConstants constants;
    constants.scale = x;
    constants.amplitude = 9 / (y * y * (5 + 4 * y));
    return constants;
  }

  [[nodiscard]] HWY_INLINE Octet support() const { return Octet(1.0); }

  /// φ for v within the support.
  template <class N>
  [[nodiscard]] HWY_INLINE N value(const N& v) const {
    const N w = N(1.0) - v;
    return w * w * (N(1.0) - N(4.0 / 9) * v);
  }
  [[nodiscard]] HWY_INLINE KernelValue value_and_slope(const Octet& v) const { return {value(v), slope(v)}; }
  /// φ″(v).
  [[nodiscard]] HWY_INLINE Octet curvature(const Octet& v) const { return Octet(34.0 / 9) - Octet(24.0 / 9) * v; }

  [[nodiscard]] HWY_INLINE OctetMask is_smooth(const Octet& v_low, const Octet& v_high) const {
    return v_low <= v_high;
  }

  /// Bounds of f = φ(v₀ + κτ²) for κτ² in [u_near, u_far], within the support.
  [[nodiscard]] HWY_INLINE SecondAndFourth on_quadratic(const Octet& v0, const Octet& kappa, const Octet& u_near,
                                                        const Octet& u_far) const {
    const auto second = [&](const Octet& u) HWY_ATTR {
      const Octet v = v0 + u;
      return Octet(2.0) * kappa * (slope(v) + Octet(2.0) * u * curvature(v));
    };
    const auto fourth = [&](const Octet& u) HWY_ATTR {
      return abs(Octet(12.0 * 34 / 9) - Octet(12.0 * 24 / 9) * v0 - Octet(160.0) * u);
    };
    const Octet top = max(u_near, min(u_far, Octet(102.0 / 120) - Octet(72.0 / 120) * v0));
    return {min(second(u_near), second(u_far)), second(top), kappa * kappa * max(fourth(u_near), fourth(u_far))};
  }

  [[nodiscard]] HWY_INLINE SlopeBounds slopes(const Octet& v_least) const {
    return {Octet(0.0) - slope(v_least), curvature(v_least), Octet(24.0 / 9), Octet(0.0)};
  }

 private:
  [[nodiscard]] static HWY_INLINE Octet slope(const Octet& v) {
    return Octet(-2.0 / 9) * (Octet(1.0) - v) * (Octet(11.0) - Octet(6.0) * v);
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
