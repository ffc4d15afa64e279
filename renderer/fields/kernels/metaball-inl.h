// The kernel of metaballs (Nishimura et al. 1985), with ρ = √v: φ = 1 − 3v for ρ ≤ 1/3, φ = (3/2)(1 − ρ)² for ρ < 1.
// The function is C¹ where the pieces meet. Amplitude and sign are left out.
//
// Outer piece: φ′ = (3/2)(1 − 1/ρ), φ″ = 3/(4ρ³), φ‴ = −9/(8ρ⁵), φ⁗ = 45/(16ρ⁷), all falling in size.
// Inner piece: φ′ = −3, φ″ = 0.
//
// Along a ray on which v = v₀ + κτ² (point, segment), φ = (3/2)(1 − 2ρ + v) in the outer piece and ρ″ = κv₀/ρ³:
//   f″ = 3κ(1 − v₀/ρ³), rising with ρ,
//   |f⁗| = 3κ²v₀|12ρ² − 15v₀|/ρ⁷ ≤ 9κ²/ρ³, since |12x − 15x²| ≤ 3 for x = v₀/ρ² in [0, 1].
// In the inner one f″ = −6κ and f⁗ = 0. The paper calls the outer piece a quadratic; along a ray past the centre it is
// not.
//
// Constants: v = xq with −xφ′(x)/φ(x) = h and amplitude 1/φ(x). In the outer piece (h ≥ ½) that is ρ/(1 − ρ) = h, in
// the inner one 3x/(1 − 3x) = h.
#if defined(ISL_RENDERER_FIELDS_KERNELS_METABALL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_KERNELS_METABALL_INL_H_
#undef ISL_RENDERER_FIELDS_KERNELS_METABALL_INL_H_
#else
#define ISL_RENDERER_FIELDS_KERNELS_METABALL_INL_H_
#endif

#include "renderer/fields/kernels/kernel_bounds-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct Metaball {
  static constexpr double kJunction = 1.0 / 9;  ///< v where the two pieces meet

  HWY_INLINE explicit Metaball(const KernelConstants&) {}

  [[nodiscard]] static KernelConstants constants(double h) {
    KernelConstants constants;
    if (h < 0.5) {
      constants.scale = h / (3 + 3 * h);
      constants.amplitude = 1 + h;  // φ(x) = 1 − 3x = 1/(1 + h)
    } else {
      const double rho = h / (1 + h);
      constants.scale = rho * rho;
      constants.amplitude = (1 + h) * (1 + h) / 1.5;  // 1 − ρ = 1/(1 + h)
    }
    return constants;
  }

  [[nodiscard]] HWY_INLINE Octet support() const { return Octet(1.0); }

  /// φ for v within the support.
  template <class N>
  [[nodiscard]] HWY_INLINE N value(const N& v) const {
    const N w = N(1.0) - sqrt(v);
    return select(v < N(kJunction), N(1.0) - N(3.0) * v, N(1.5) * w * w);
  }
  [[nodiscard]] HWY_INLINE KernelValue value_and_slope(const Octet& v) const {
    return {value(v), Octet(1.5) - Octet(1.5) / outer_root(v)};
  }
  /// φ″(v).
  [[nodiscard]] HWY_INLINE Octet curvature(const Octet& v) const {
    return keep(v >= Octet(kJunction), Octet(0.75) / cube(outer_root(v)));
  }

  [[nodiscard]] HWY_INLINE OctetMask is_smooth(const Octet& v_low, const Octet& v_high) const {
    return (v_low >= Octet(kJunction)) | (v_high < Octet(kJunction));
  }

  /// Bounds of f = φ(v₀ + κτ²) for κτ² in [u_near, u_far], within the support.
  [[nodiscard]] HWY_INLINE SecondAndFourth on_quadratic(const Octet& v0, const Octet& kappa, const Octet& u_near,
                                                        const Octet& u_far) const {
    const Octet v_near = v0 + u_near, v_far = v0 + u_far;
    const Octet near3 = cube(outer_root(v_near)), far3 = cube(outer_root(v_far));
    const Octet low = Octet(3.0) * kappa * (Octet(1.0) - v0 / near3),
                high = Octet(3.0) * kappa * (Octet(1.0) - v0 / far3);
    const Octet inner = Octet(-6.0) * kappa;
    const OctetMask starts_inside = v_near < Octet(kJunction), ends_inside = v_far < Octet(kJunction);
    return {select(starts_inside, min(inner, low), low), select(ends_inside, inner, high),
            select(ends_inside, Octet(0.0), Octet(9.0) * kappa * kappa / near3)};
  }

  [[nodiscard]] HWY_INLINE SlopeBounds slopes(const Octet& v_least) const {
    const Octet rho = outer_root(v_least), rho3 = cube(rho);
    const Octet rho5 = rho3 * rho * rho;
    return {Octet(1.5) / rho - Octet(1.5), Octet(0.75) / rho3, Octet(9.0 / 8) / rho5,
            Octet(45.0 / 16) / (rho5 * rho * rho)};
  }

 private:
  /// ρ, clamped to where the outer piece begins: there the slopes of both pieces are equal.
  [[nodiscard]] static HWY_INLINE Octet outer_root(const Octet& v) { return sqrt(max(v, Octet(kJunction))); }
  [[nodiscard]] static HWY_INLINE Octet cube(const Octet& x) { return x * x * x; }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
