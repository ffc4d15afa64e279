// The cubic kernel: φ(v) = (1 − v)³, v < 1, whose curvature vanishes at its border. Amplitude and sign are
// left out.
//
// It is also the field of a plane that is convolved with the quartic window (1 − y)², y = the squared distance over the
// squared support radius: a ring of the plane between squared radii u and u + du about the foot of the point has the
// area π du, and
//   ∫ (1 − v − u)² π du over 0 < u < 1 − v  =  (π/3)(1 − v)³.
//
// Along a ray on which v = v₀ + κτ²: with u = κτ² and w = 1 − v₀
//   f″ = 6κ(w − u)(5u − w), which rises to 4.8κw² at u = 0.6w and falls after;   f⁗ = 72κ²(w − 5u), monotone.
//
// Constants: v = q/Q with Q = 1 + 3/h and amplitude (1 + h/3)³: the slope at q = 1 is −3 amplitude (1 − 1/Q)²/Q = −h.
#if defined(ISL_RENDERER_FIELDS_KERNELS_CUBIC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_KERNELS_CUBIC_INL_H_
#undef ISL_RENDERER_FIELDS_KERNELS_CUBIC_INL_H_
#else
#define ISL_RENDERER_FIELDS_KERNELS_CUBIC_INL_H_
#endif

#include "renderer/fields/kernels/kernel_bounds-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct Cubic {
  HWY_INLINE explicit Cubic(const KernelConstants&) {}

  [[nodiscard]] static KernelConstants constants(double h) {
    KernelConstants constants;
    const double root = 1 + h / 3;
    constants.scale = h / (h + 3);
    constants.amplitude = root * root * root;
    return constants;
  }

  [[nodiscard]] HWY_INLINE Octet support() const { return Octet(1.0); }

  /// φ for v within the support.
  template <class N>
  [[nodiscard]] HWY_INLINE N value(const N& v) const {
    const N w = N(1.0) - v;
    return w * w * w;
  }
  [[nodiscard]] HWY_INLINE KernelValue value_and_slope(const Octet& v) const {
    const Octet w = Octet(1.0) - v, square = w * w;
    return {square * w, Octet(-3.0) * square};
  }
  /// φ″(v).
  [[nodiscard]] HWY_INLINE Octet curvature(const Octet& v) const { return Octet(6.0) * (Octet(1.0) - v); }

  [[nodiscard]] HWY_INLINE OctetMask is_smooth(const Octet& v_low, const Octet& v_high) const {
    return v_low <= v_high;
  }

  /// Bounds of f = φ(v₀ + κτ²) for κτ² in [u_near, u_far], within the support.
  [[nodiscard]] HWY_INLINE SecondAndFourth on_quadratic(const Octet& v0, const Octet& kappa, const Octet& u_near,
                                                        const Octet& u_far) const {
    const Octet w = Octet(1.0) - v0, five(5.0), top = Octet(0.6) * w;
    const auto second = [&](const Octet& u) HWY_ATTR { return Octet(6.0) * (w - u) * (five * u - w); };
    const Octet near = second(u_near), far = second(u_far);
    const Octet high = select((u_near < top) & (u_far > top), Octet(4.8) * w * w, max(near, far));
    const Octet fourth = Octet(72.0) * max(abs(w - five * u_near), abs(w - five * u_far));
    return {kappa * min(near, far), kappa * high, kappa * kappa * fourth};
  }

  [[nodiscard]] HWY_INLINE SlopeBounds slopes(const Octet& v_least) const {
    const Octet w = Octet(1.0) - v_least;
    return {Octet(3.0) * w * w, Octet(6.0) * w, Octet(6.0), Octet(0.0)};
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
