// A plane convolved with the Cauchy window (cauchy_window-inl.h), here in squared radii: A = ε + v, B = ε + Q,
// d = Q − v, v = q. A ring of the plane between squared radii u and u + du about the foot of the point has the area
// π du, so the integral is over v alone:
//   φ(v) = ∫ 1/Y² − 1/B² − 2(B − Y)/B³ dY from A to B = 1/A − 1/B − d/B² − d²/B³ = d³/(AB³), v < Q,
//   φ′ = −d²(B + 2A)/(A²B³),   φ″ = 2/A³ − 2/B³ = 2d(A² + AB + B²)/(A³B³),   φ‴ = −6/A⁴,   φ⁗ = 24/A⁵.
// Amplitude and sign are left out.
//
// Along a ray on which v = v₀ + κτ², with u = κτ², p = ε + v₀ and y = u/p:
//   f″ = κ(2φ′ + 4uφ″), in which 2φ′ rises and φ″ falls with u: so each term is bounded by its values at the ends. On
//   long stretches that is far too wide beside a spike at u = 0; for these
//   f″ = κ((6u − 2p)/(p + u)³ + 6/B² − (4p + 12u)/B³) is bounded term by term; the first term rises to ½/p² at u = p
//   and falls after. The tighter of the two bounds is used.
//   f⁗ = κ²(s(y)/p³ − 24/B³), s(y) = 24(1 − 10y + 5y²)/(1 + y)⁵, which falls to −10.125 at y = ⅓, rises to 0.375 at
//   y = 3, and falls towards zero.
//
// Constants: φ′(1)/φ(1) = −3/(Q − 1) − 1/(1 + ε) = −h gives Q for any ε; ε follows from one more equation, φ(0) = eʰ,
// which the kernels of points and lines fulfil as well. ln(φ(0)/φ(1)) falls from above h to below it (the quartic's) as
// ε grows. Below ε = 10⁻⁴⁰, a hardness of about 100, only the value within 10⁻²⁰ radii of the plane changes, and the
// powers of ε would leave the range of numbers.
#if defined(ISL_RENDERER_FIELDS_KERNELS_SHEET_CAUCHY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_KERNELS_SHEET_CAUCHY_INL_H_
#undef ISL_RENDERER_FIELDS_KERNELS_SHEET_CAUCHY_INL_H_
#else
#define ISL_RENDERER_FIELDS_KERNELS_SHEET_CAUCHY_INL_H_
#endif

#include "renderer/fields/kernels/kernel_bounds-inl.h"
#include "renderer/numerics/bisection.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct CauchySheet {
  double epsilon, support_, border;  ///< ε, Q, B

  HWY_INLINE explicit CauchySheet(const KernelConstants& k)
      : epsilon(k.a), support_(k.support), border(k.a + k.support) {}

  [[nodiscard]] static KernelConstants constants(double h) {
    const double least = std::max(0.0, 1 / h - 1);  // the ε at which Q is infinite
    const auto width = [&](double epsilon) { return 3 * (1 + epsilon) / (h * (1 + epsilon) - 1); };  // Q − 1
    const auto is_too_small = [&](double epsilon) {
      return 3 * std::log1p(1 / width(epsilon)) + std::log1p(1 / epsilon) > h;
    };
    const auto above_least = [&](double log_excess) { return least + std::exp(log_excess); };
    KernelConstants constants;
    constants.a = above_least(last_where([&](double x) { return is_too_small(above_least(x)); }, std::log(1e-40),
                                         std::log(1e6)));  // ε − least is below 1/h for the softest
    // The amplitude is 1/φ(1). Q − 1 has lost digits in the rounded Q, which a field far within must not be off by.
    const double a = 1 + constants.a, d = width(constants.a), b_over_d = (a + d) / d;
    constants.support = 1 + d;
    constants.amplitude = a * b_over_d * b_over_d * b_over_d;
    return constants;
  }

  [[nodiscard]] HWY_INLINE Octet support() const { return Octet(support_); }

  /// φ for v within the support.
  template <class N>
  [[nodiscard]] HWY_INLINE N value(const N& v) const {
    const N d = N(support_) - v;
    return d * d * d / ((N(epsilon) + v) * N(border * border * border));
  }
  [[nodiscard]] HWY_INLINE KernelValue value_and_slope(const Octet& v) const { return {value(v), slope(v)}; }
  /// φ″(v).
  [[nodiscard]] HWY_INLINE Octet curvature(const Octet& v) const {
    const Octet a = Octet(epsilon) + v, b(border), d = Octet(support_) - v, ab = a * b;
    return Octet(2.0) * d * (a * a + ab + b * b) / (ab * ab * ab);
  }

  [[nodiscard]] HWY_INLINE OctetMask is_smooth(const Octet& v_low, const Octet& v_high) const {
    return v_low <= v_high;
  }

  /// Bounds of f = φ(v₀ + κτ²) for κτ² in [u_near, u_far], within the support.
  [[nodiscard]] HWY_INLINE SecondAndFourth on_quadratic(const Octet& v0, const Octet& kappa, const Octet& u_near,
                                                        const Octet& u_far) const {
    const Octet two(2.0), four(4.0), p = Octet(epsilon) + v0;
    const Octet v_near = v0 + u_near, v_far = v0 + u_far;
    const Octet low_by_ends = two * slope(v_near) + four * u_near * curvature(v_far);
    const Octet high_by_ends = two * slope(v_far) + four * u_far * curvature(v_near);

    const auto spike = [&](const Octet& u) HWY_ATTR {
      const Octet a = p + u;
      return (Octet(6.0) * u - two * p) / (a * a * a);
    };
    const auto window = [&](const Octet& u) HWY_ATTR {
      return Octet(6 / (border * border)) - (four * p + Octet(12.0) * u) * Octet(1 / (border * border * border));
    };
    const Octet near = spike(u_near), far = spike(u_far);
    const Octet top = select((u_near < p) & (u_far > p), Octet(0.5) / (p * p), max(near, far));
    // The terms cancel towards the border. Their rounding is a few units in the last place of the greatest one.
    const Octet rounding = Octet(0x1p-49) * (max(abs(near), abs(far)) + Octet(6 / (border * border)));
    const Octet low = max(low_by_ends, min(near, far) + window(u_far) - rounding);
    const Octet high = min(high_by_ends, top + window(u_near) + rounding);
    return {kappa * low, kappa * high, kappa * kappa * fourth(p, u_near, u_far)};
  }

  [[nodiscard]] HWY_INLINE SlopeBounds slopes(const Octet& v_least) const {
    const Octet a = Octet(epsilon) + v_least, a4 = a * a * a * a;
    return {Octet(0.0) - slope(v_least), curvature(v_least), Octet(6.0) / a4, Octet(24.0) / (a4 * a)};
  }

 private:
  [[nodiscard]] HWY_INLINE Octet slope(const Octet& v) const {
    const Octet a = Octet(epsilon) + v, d = Octet(support_) - v;
    return Octet(-1.0) * d * d * (Octet(border) + a + a) / (a * a * Octet(border * border * border));
  }
  /// |f⁗|/κ².
  [[nodiscard]] HWY_INLINE Octet fourth(const Octet& p, const Octet& u_near, const Octet& u_far) const {
    const auto at = [&](const Octet& u) HWY_ATTR {
      const Octet a = p + u, square = a * a;
      return (Octet(24.0) * p * p - Octet(240.0) * p * u + Octet(120.0) * u * u) / (square * square * a);
    };
    const Octet near = at(u_near), far = at(u_far), cube = Octet(1.0) / (p * p * p);
    const Octet third = Octet(1.0 / 3) * p, three = Octet(3.0) * p;
    const Octet low = select((u_near < third) & (u_far > third), Octet(-10.125) * cube, min(near, far));
    const Octet high =
        select((u_near < three) & (u_far > three), max(max(near, far), Octet(0.375) * cube), max(near, far));
    const Octet window(24 / (border * border * border));
    return max(abs(low - window), abs(high - window));
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
