// The quartic kernel (Murakami and Ichihara 1987; POV-Ray's blobs): φ(v) = (1 − v)², v < 1. Amplitude and sign
// are left out.
//
// Along a ray on which v = v₀ + κτ² (point, segment): with u = κτ²
//   f″ = −4κ(1 − v₀ − 3u), monotone in u;   f⁗ = 24κ², a constant.
// For any other skeleton, the bounds follow from those of v and its derivatives with φ′ = −2(1 − v), φ″ = 2, and
// φ‴ = φ⁗ = 0.
//
// Constants: v = q/Q with Q = 1 + 2/h and amplitude (1 + h/2)²: the slope at q = 1 is −2 amplitude (1 − 1/Q)/Q = −h.
#if defined(ISL_RENDERER_FIELDS_KERNELS_QUARTIC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_KERNELS_QUARTIC_INL_H_
#undef ISL_RENDERER_FIELDS_KERNELS_QUARTIC_INL_H_
#else
#define ISL_RENDERER_FIELDS_KERNELS_QUARTIC_INL_H_
#endif

#include "renderer/fields/kernels/kernel_bounds-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct Quartic {
  HWY_INLINE explicit Quartic(const KernelConstants&) {}

  [[nodiscard]] static KernelConstants constants(double h) {
    KernelConstants constants;
    constants.scale = 1 / (1 + 2 / h);
    constants.amplitude = (1 + h / 2) * (1 + h / 2);
    return constants;
  }

  /// An upper bound of |dφ/d√v| = 4√v(1 − v), which is greatest at v = 1/3.
  static constexpr double kSteepest = 1.5397;

  [[nodiscard]] HWY_INLINE Octet support() const { return Octet(1.0); }

  /// φ for v within the support.
  template <class N>
  [[nodiscard]] HWY_INLINE N value(const N& v) const {
    const N w = N(1.0) - v;
    return w * w;
  }
  [[nodiscard]] HWY_INLINE KernelValue value_and_slope(const Octet& v) const {
    const Octet w = Octet(1.0) - v;
    return {w * w, Octet(-2.0) * w};
  }
  /// φ″(v).
  [[nodiscard]] HWY_INLINE Octet curvature(const Octet&) const { return Octet(2.0); }

  [[nodiscard]] HWY_INLINE OctetMask is_smooth(const Octet& v_low, const Octet& v_high) const {
    return v_low <= v_high;
  }

  /// Bounds of f = φ(v₀ + κτ²) for κτ² in [u_near, u_far], within the support.
  [[nodiscard]] HWY_INLINE SecondAndFourth on_quadratic(const Octet& v0, const Octet& kappa, const Octet& u_near,
                                                        const Octet& u_far) const {
    const Octet factor = Octet(4.0) * kappa;
    const Octet w0 = Octet(1.0) - v0;
    return {factor * (Octet(3.0) * u_near - w0), factor * (Octet(3.0) * u_far - w0), Octet(24.0) * kappa * kappa};
  }

  [[nodiscard]] HWY_INLINE SlopeBounds slopes(const Octet& v_least) const {
    return {Octet(2.0) * (Octet(1.0) - v_least), Octet(2.0), Octet(0.0), Octet(0.0)};
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
