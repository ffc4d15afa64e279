// Eight round cones (skeletons/cone.h) along a ray. With w = r₀ + kx, N = ρ² and M = w² + k²N, all polynomials of t:
//
//   u* = x + kN/w in [0, L]:  q = N/M, so that  q′ = (N′ − qM′)/M,  q″ = (N″ − 2q′M′ − qM″)/M,
//                             q‴ = −3(q″M′ + q′M″)/M,  q⁗ = −(4q‴M′ + 6q″M″)/M        (differentiate qM = N)
//   else at an end:           q = ((x − u)² + N)/r(u)², a quadratic.
//
// Values take the nearest sphere u directly: q = ((x − u)² + N)/r², and since u is either at the minimum or fixed,
// q′ = (2(x − u)x′ + N′)/r² (the envelope theorem). Bounds hold for each of the three pieces that an interval can
// touch; where it certainly touches one only, f is smooth there.
#if defined(ISL_RENDERER_FIELDS_SKELETONS_CONE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_SKELETONS_CONE_LANES_INL_H_
#undef ISL_RENDERER_FIELDS_SKELETONS_CONE_LANES_INL_H_
#else
#define ISL_RENDERER_FIELDS_SKELETONS_CONE_LANES_INL_H_
#endif

#include "renderer/fields/kernels/kernel_bounds-inl.h"
#include "renderer/fields/skeletons/lane_point-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct ConeBounds {
  JetBounds at_a, at_b, body;
  OctetMask may_a, may_b, may_body;
  OctetMask one_piece;
  Octet least, greatest;  ///< of v

  /// The union over the pieces that the interval may touch.
  template <class Kernel>
  [[nodiscard]] HWY_INLINE SecondAndFourth compose(const Kernel& kernel) const {
    const SecondAndFourth a = render::HWY_NAMESPACE::compose(kernel, at_a);
    const SecondAndFourth b = render::HWY_NAMESPACE::compose(kernel, at_b);
    const SecondAndFourth c = render::HWY_NAMESPACE::compose(kernel, body);
    const Octet lowest(-1e300), highest(1e300);
    return {min(select(may_a, a.low, highest), min(select(may_b, b.low, highest), select(may_body, c.low, highest))),
            max(select(may_a, a.high, lowest), max(select(may_b, b.high, lowest), select(may_body, c.high, lowest))),
            max(keep(may_a, a.fourth), max(keep(may_b, b.fourth), keep(may_body, c.fourth)))};
  }
  /// |f′| on the interval is no greater.
  template <class Kernel>
  [[nodiscard]] HWY_INLINE Octet steepest(const Kernel& kernel) const {
    const auto of = [&](const JetBounds& v) HWY_ATTR { return kernel.slopes(v.least).first * v.first; };
    return max(keep(may_a, of(at_a)), max(keep(may_b, of(at_b)), keep(may_body, of(body))));
  }
};

struct ConeLanes {
  Octet x0, dx, n0, n2, middle, radius, k, length, amplitude;

  [[nodiscard]] HWY_INLINE Octet nearest(const Octet& x, const Octet& n) const {
    const Octet w = radius + k * x;
    const Octet u = max(Octet(0.0), min(length, x + k * n / w));
    return select(w > Octet(0.0), u, select(k > Octet(0.0), length, Octet(0.0)));
  }

  [[nodiscard]] HWY_INLINE LanePoint at(const Octet& t, double scale) const {
    const Octet x = x0 + dx * t, tau = t - middle;
    const Octet n = n0 + n2 * tau * tau;
    const Octet u = nearest(x, n);
    const Octet r = radius + k * u, e = x - u;
    const Octet factor = Octet(scale) / (r * r);
    return {factor * (e * e + n), factor * (Octet(2.0) * (e * dx + n2 * tau))};
  }

  /// v″, of the piece that t lies on.
  [[nodiscard]] HWY_INLINE Octet second(const Octet& t, double scale) const {
    const Octet x = x0 + dx * t, tau = t - middle;
    const Octet n = n0 + n2 * tau * tau, w = radius + k * x;
    const Octet u = nearest(x, n), r = radius + k * u;
    const Octet speed2 = dx * dx + n2;
    const Octet at_end = Octet(2.0) * speed2 / (r * r);
    const Octet m = w * w + k * k * n, m1 = Octet(2.0) * (w * k * dx + k * k * n2 * tau),
                m2 = Octet(2.0) * k * k * speed2;
    const Octet q = n / m, q1 = (Octet(2.0) * n2 * tau - q * m1) / m;
    const Octet on_body = (Octet(2.0) * n2 - Octet(2.0) * q1 * m1 - q * m2) / m;
    return Octet(scale) * select((u > Octet(0.0)) & (u < length), on_body, at_end);
  }

  [[nodiscard]] HWY_INLINE ConeBounds bounds(const Octet& t0, const Octet& t1, double scale, double support) const {
    const Octet zero(0.0), two(2.0);
    const Octet xa = x0 + dx * t0, xb = x0 + dx * t1;
    const Octet x_low = min(xa, xb), x_high = max(xa, xb);
    const Octet a = t0 - middle, b = t1 - middle;
    const Octet near = max(zero, max(a, zero - b)), far = max(abs(a), abs(b));
    const Octet n_low = n0 + n2 * near * near, n_high = n0 + n2 * far * far;
    const Octet wa = radius + k * xa, wb = radius + k * xb;
    const Octet w_low = min(wa, wb), w_high = max(wa, wb);

    // Where u* = (xw + kN)/w stands against 0 and L, from the corners of the ranges.
    const OctetMask ahead = w_low > zero, behind = w_high <= zero, widens = k > zero;
    const Octet kn_low = min(k * n_low, k * n_high), kn_high = max(k * n_low, k * n_high);
    const auto product = [&](const Octet& shift, Octet& low, Octet& high) HWY_ATTR {
      const Octet p = (x_low - shift) * w_low, q = (x_low - shift) * w_high;
      const Octet r = (x_high - shift) * w_low, s = (x_high - shift) * w_high;
      low = min(min(p, q), min(r, s)) + kn_low;
      high = max(max(p, q), max(r, s)) + kn_high;
    };
    Octet from_a_low, from_a_high, from_b_low, from_b_high;
    product(zero, from_a_low, from_a_high);
    product(length, from_b_low, from_b_high);
    const OctetMask only_a = (ahead & (from_a_high <= zero)) | (behind & (k < zero));
    const OctetMask only_b = (ahead & (from_b_low >= zero)) | (behind & widens);
    const OctetMask only_body = ahead & (from_a_low >= zero) & (from_b_high <= zero);
    const auto without = [&](const OctetMask& m, const OctetMask& out) HWY_ATTR {
      OctetMask r = m;
      for (std::size_t i = 0; i < kRegisters; ++i) r.m[i] = hn::AndNot(out.m[i], m.m[i]);
      return r;
    };
    const OctetMask all = zero < Octet(1.0);
    ConeBounds result;
    result.one_piece = only_a | only_b | only_body;
    result.may_a = without(all, (ahead & (from_a_low >= zero)) | only_b);
    result.may_b = without(all, (ahead & (from_b_high <= zero)) | only_a);
    result.may_body = without(all, only_a | only_b);

    const Octet speed2 = dx * dx + n2;
    const auto end = [&](const Octet& u) HWY_ATTR {
      const Octet r = radius + k * u;
      const Octet factor = Octet(scale) / max(r * r, Octet(kLeast));
      const Octet ea = xa - u, eb = xb - u;
      const Octet e_near = max(zero, max(x_low - u, u - x_high));
      JetBounds v;
      v.least = factor * (e_near * e_near + n_low);
      v.first = factor * two * max(abs(ea * dx + n2 * a), abs(eb * dx + n2 * b));
      v.second_low = v.second_high = factor * two * speed2;
      v.third = v.fourth = zero;
      return capped(v);
    };
    result.at_a = end(zero);
    result.at_b = end(length);

    const Octet w_from = max(w_low, zero), kk = k * k;
    const Octet m_low = max(w_from * w_from + kk * n_low, Octet(kLeast));
    const Octet m1 = two * (w_high * abs(k * dx) + kk * n2 * far), m2 = two * kk * speed2;
    const Octet q_low = n_low / max(w_high * w_high + kk * n_low, Octet(kLeast));
    const Octet q_high = n_high / max(w_from * w_from + kk * n_high, Octet(kLeast));
    const Octet inverse = Octet(1.0) / m_low;
    // Also |q′| = 2√q |(p − c)·D|/(|p − c| r) ≤ 2√q |D|/r, and the nearest sphere is no thinner than r(x) nor than the
    // thin end; beyond the support nothing counts.
    const Octet r_low = max(w_from, min(radius, radius + k * length));
    const Octet q_counts = min(q_high, Octet(support / scale));
    const Octet steepest = two * sqrt(q_counts * speed2) / max(r_low, Octet(kLeast));
    const Octet q1 = min((two * n2 * far + q_high * m1) * inverse, steepest);
    const Octet q2_low = zero - (two * q1 * m1 + q_high * m2) * inverse, q2_high = (two * n2 + two * q1 * m1) * inverse;
    const Octet q2 = max(q2_high, zero - q2_low);
    const Octet q3 = Octet(3.0) * (q2 * m1 + q1 * m2) * inverse;
    const Octet q4 = (Octet(4.0) * q3 * m1 + Octet(6.0) * q2 * m2) * inverse;
    const Octet s(scale);
    result.body = capped({s * q_low, s * q1, s * q2_low, s * q2_high, s * q3, s * q4});

    const Octet highest(1e300);
    result.least =
        min(select(result.may_a, result.at_a.least, highest),
            min(select(result.may_b, result.at_b.least, highest), select(result.may_body, result.body.least, highest)));
    // Along the ray q ≤ its value at any one sphere: at that nearest to the middle of the interval, which is all but it where the
    // interval is short, or at either end's, unless its radius vanishes.
    const auto farthest = [&](const Octet& u) HWY_ATTR {
      const Octet r = radius + k * u, e = max(abs(x_low - u), abs(x_high - u));
      return Octet(scale) * (e * e + n_high) / max(r * r, Octet(kLeast));
    };
    const Octet half(0.5), tau = half * (a + b);
    const Octet between = nearest(half * (xa + xb), n0 + n2 * tau * tau);
    result.greatest = min(farthest(between), min(farthest(zero), farthest(length)));
    return result;
  }

 private:
  /// Keeps the products of bounds finite where the cone's apex comes into the interval (M = 0): far beyond any use, so
  /// that the interval is divided there.
  static constexpr double kLeast = 1e-100, kMost = 1e60;
  static HWY_INLINE JetBounds capped(const JetBounds& v) {
    const Octet most(kMost);
    return {v.least,
            min(v.first, most),
            max(v.second_low, Octet(-kMost)),
            min(v.second_high, most),
            min(v.third, most),
            min(v.fourth, most)};
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
