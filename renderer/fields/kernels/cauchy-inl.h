// The Cauchy kernel (McCormack and Sherstyuk 1998) less its tangent at the border: with v = q, ε = 1/σ², A = ε + v,
// B = ε + Q and d = Q − v,
//   φ(v) = 1/A² − 1/B² − 2d/B³ = d²(B + 2A)/(A²B³), v < Q,
//   φ′ = −2/A³ + 2/B³ = −2d(B² + AB + A²)/(A³B³),   φ″ = 6/A⁴,   φ‴ = −24/A⁵,   φ⁗ = 120/A⁶.
// Amplitude and sign are left out.
//
// Along a ray on which v = v₀ + κτ² (point, segment), with u = κτ², p = ε + v₀ and y = u/p:
//   f″ = κ(4/B³ + (20u − 4p)/(p + u)⁴), whose second term rises to 1.220703125/p³ at y = 0.6 (8/1.6⁴) and falls after,
//   f⁗ = κ²(72p² − 1008pu + 840u²)/(p + u)⁶, which falls from y = 2 on.
// Before y = 2, f⁗ is bounded by a falling staircase over y, each step the maximum to its right.
//
// Constants: among the Cauchy kernels with φ(1) = 1 and φ′(1) = −h, the one with φ(0) = eʰ is taken, which is the value
// of the unwindowed Gaussian. With r = B/A at v = 1, φ′/φ = −2(r² + r + 1)/(A(r − 1)(r + 2)) = −h gives r for any ε;
// φ(0)/φ(1) = eʰ then is one equation for ε.
#if defined(ISL_RENDERER_FIELDS_KERNELS_CAUCHY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_KERNELS_CAUCHY_INL_H_
#undef ISL_RENDERER_FIELDS_KERNELS_CAUCHY_INL_H_
#else
#define ISL_RENDERER_FIELDS_KERNELS_CAUCHY_INL_H_
#endif

#include "renderer/fields/kernels/kernel_bounds-inl.h"
#include "renderer/numerics/bisection.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct Cauchy {
  double epsilon, support_, border;  ///< ε, Q, B

  HWY_INLINE explicit Cauchy(const KernelConstants& k) : epsilon(k.a), support_(k.support), border(k.a + k.support) {}

  [[nodiscard]] static KernelConstants constants(double h) {
    // ε > ε₀, the least for which r exists; ln(φ(0)/φ(1)) − h falls from above zero to below it as ε grows.
    const double least = std::max(0.0, 2 / h - 1);
    const auto width = [&](double epsilon) {              // Q − 1
      const double excess = 6 / (h * (1 + epsilon) - 2);  // r² + r − 2
      return (1 + epsilon) * 2 * excess / (std::sqrt(9 + 4 * excess) + 3);
    };
    const auto is_too_small = [&](double epsilon) {
      const double a = 1 + epsilon, d = width(epsilon), b = a + d;
      return 2 * std::log((1 + d) / d) + std::log((b + 2 * epsilon) / (b + 2 * a)) + 2 * std::log(a / epsilon) > h;
    };
    const auto above_least = [&](double log_excess) { return least + std::exp(log_excess); };
    KernelConstants constants;
    // ε is about e^{−h/2} for the hardest kernel, h = 500, and ε − least about 1/h for the softest.
    constants.a = above_least(last_where([&](double x) { return is_too_small(above_least(x)); }, -300, 300));
    // The amplitude is 1/φ(1). Q − 1 has lost digits in the rounded Q, which a field far within must not be off by.
    const double a = 1 + constants.a, d = width(constants.a), b = a + d;
    constants.support = 1 + d;
    constants.amplitude = a * a * b * b * b / (d * d * (b + 2 * a));
    return constants;
  }

  [[nodiscard]] HWY_INLINE Octet support() const { return Octet(support_); }

  /// φ for v within the support.
  template <class N>
  [[nodiscard]] HWY_INLINE N value(const N& v) const {
    const N a = N(epsilon) + v, d = N(support_) - v;
    return d * d * (N(border) + N(2.0) * a) / (a * a * N(border * border * border));
  }
  [[nodiscard]] HWY_INLINE KernelValue value_and_slope(const Octet& v) const {
    // At the centre of the hardest kernel, where ε ≈ 10⁻¹⁰⁷, the slope would overflow.
    return {value(v), slope(max(Octet(epsilon) + v, Octet(1e-100)), v)};
  }
  /// φ″(v).
  [[nodiscard]] HWY_INLINE Octet curvature(const Octet& v) const {
    return Octet(6.0) / fourth_power(Octet(epsilon) + v);
  }

  [[nodiscard]] HWY_INLINE OctetMask is_smooth(const Octet& v_low, const Octet& v_high) const {
    return v_low <= v_high;
  }

  /// Bounds of f = φ(v₀ + κτ²) for κτ² in [u_near, u_far], within the support.
  [[nodiscard]] HWY_INLINE SecondAndFourth on_quadratic(const Octet& v0, const Octet& kappa, const Octet& u_near,
                                                        const Octet& u_far) const {
    const Octet p = Octet(epsilon) + v0, window(4 / (border * border * border));
    const auto second = [&](const Octet& u)
                            HWY_ATTR { return (Octet(20.0) * u - Octet(4.0) * p) / fourth_power(p + u); };
    const Octet near = second(u_near), far = second(u_far), top = Octet(0.6) * p;
    const Octet high = select((u_near < top) & (u_far > top), Octet(1.220703125) / (p * p * p), max(near, far));
    const Octet reach = p + u_near;
    const Octet tail = (Octet(72.0) * p * p - Octet(1008.0) * p * u_near + Octet(840.0) * u_near * u_near) /
                       (fourth_power(reach) * reach * reach);
    const Octet fourth = select(u_near >= Octet(2.0) * p, tail, profile4(u_near / p) / fourth_power(p));
    return {kappa * (window + min(near, far)), kappa * (window + high), kappa * kappa * fourth};
  }

  [[nodiscard]] HWY_INLINE SlopeBounds slopes(const Octet& v_least) const {
    const Octet a = Octet(epsilon) + v_least, a4 = fourth_power(a);
    return {Octet(0.0) - slope(a, v_least), Octet(6.0) / a4, Octet(24.0) / (a4 * a), Octet(120.0) / (a4 * a * a)};
  }

 private:
  [[nodiscard]] HWY_INLINE Octet slope(const Octet& a, const Octet& v) const {
    const Octet b(border), d = Octet(support_) - v;
    return Octet(-2.0) * d * (b * b + a * b + a * a) / (a * a * a * Octet(border * border * border));
  }
  [[nodiscard]] static HWY_INLINE Octet fourth_power(const Octet& x) {
    const Octet square = x * x;
    return square * square;
  }
  /// max over z ≥ y of |72 − 1008z + 840z²|/(1 + z)⁶, from above, for y < 2.
  [[nodiscard]] static HWY_INLINE Octet profile4(const Octet& y) {
    struct Step {
      double from, bound;
    };
    constexpr Step kSteps[] = {{0.01, 58.42}, {0.02, 46.34}, {0.04, 33.45}, {0.3, 32.08}, {0.4, 26.14}, {0.5, 19.50},
                               {0.6, 13.74},  {0.7, 9.20},   {0.8, 5.79},   {0.9, 3.30},  {1.0, 2.04}};
    Octet bound(72.0);
    for (const Step& step : kSteps) bound = select(y >= Octet(step.from), Octet(step.bound), bound);
    return bound;
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
