// The Cauchy kernel (McCormack and Sherstyuk 1998) less its tangent at the border, as a window to integrate: y = the
// squared distance in support radii, Y = ε + y, B = ε + 1, d = 1 − y,
//   g(y) = 1/Y² − 1/B² − 2d/B³ = d²(B + 2Y)/(Y²B³),  g′ = −2/Y³ + 2/B³,  g″ = 6/Y⁴,  g‴ = −24/Y⁵.
// The tangent is subtracted inside the integral, so that the halves of a skeleton add up to the whole.
//
// Along a ray past a fixed point, with e = (p − s)·D, y′ = 2e, y″ = 2D² and β = e²/(D²Y) < 1:
//   g″ = 4D²/B³ + D²(24β − 4)/Y³,  g‴ = 24eD²(3 − 8β)/Y⁴,  g⁗ = 24D⁴(3 − 48β + 80β²)/Y⁴.
// |3 − 48β + 80β²| is at most 3 up to β = ⅛ and 4.2 (at β = 0.3) up to 0.6; from there it rises.
// √β|3 − 8β| is at most 1/√2 (at β = ⅛) before it rises beyond ⅜.
//
// Integrals over a curve fall off with the distance from its nearest point: ∫Y⁻³ds along a line is at most
// (3π/8)√Y₀/Y₀³, and higher powers' less, Y₀ the least of Y. So the effective length of a curve is at most 1.1781√Y₀,
// times the factor by which the distance grows more slowly than along a line.
#if defined(ISL_RENDERER_FIELDS_CONVOLUTIONS_CAUCHY_WINDOW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_CONVOLUTIONS_CAUCHY_WINDOW_INL_H_
#undef ISL_RENDERER_FIELDS_CONVOLUTIONS_CAUCHY_WINDOW_INL_H_
#else
#define ISL_RENDERER_FIELDS_CONVOLUTIONS_CAUCHY_WINDOW_INL_H_
#endif

#include "renderer/fields/convolutions/window_bounds-inl.h"
#include "renderer/fields/kernels/kernel_constants.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct CauchyWindow {
  double epsilon, border;  ///< ε, B
  bool is_steep;           ///< the surface of the kernel alone is at most B/8 deep

  HWY_INLINE explicit CauchyWindow(const KernelConstants& k)
      : epsilon(k.a), border(1 + k.a), is_steep(8 * (1 - k.scale) < 1 + k.a) {}

  template <class N>
  [[nodiscard]] HWY_INLINE N value(const N& y) const {
    const N a = N(epsilon) + y, d = N(1.0) - y;
    return d * d * (N(border) + N(2.0) * a) / (a * a * N(border * border * border));
  }
  [[nodiscard]] HWY_INLINE double second_at_border() const { return 6 / (border * border * border * border); }
  [[nodiscard]] HWY_INLINE double third_at_border() const { return 24 / (border * border * border * border * border); }

  [[nodiscard]] HWY_INLINE WindowBounds bounds(const Octet& y_least, const Octet& e2, const Octet& speed2) const {
    const Octet y = Octet(epsilon) + y_least, y2 = y * y, y3 = y * y2, one(1.0);
    const Octet beta = min(one, e2 / max(speed2 * y, Octet(1e-300)));  // 0 if D = 0
    const Octet low = Octet(4 / (border * border * border)) - Octet(4.0) / y3;
    const Octet third = max(Octet(0.70711), sqrt(beta) * (Octet(8.0) * beta - Octet(3.0)));
    const Octet fourth = max(select(beta < Octet(0.125), Octet(3.0), Octet(4.2)),
                             Octet(3.0) + beta * (Octet(80.0) * beta - Octet(48.0)));
    return {speed2 * min(low, Octet(0.0)), Octet(24.0) * beta * speed2 / y3,
            Octet(24.0) * speed2 * sqrt(speed2 * y) * third / (y2 * y2),
            Octet(24.0) * speed2 * speed2 * fourth / (y2 * y2)};
  }
  [[nodiscard]] HWY_INLINE Octet effective_length(const Octet& length, const Octet& y_least,
                                                  const Octet& spread) const {
    return min(length, Octet(1.1781) * spread * sqrt(Octet(epsilon) + y_least));
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
