// Eight convolved rings along a ray, in support radii: z = z₀ + z′t along the axis from the ring's centre, ρ² = n₀ +
// n₂(t − tₙ)² from the axis.
//
// With S = 1 − d² and a = 2Rρ (curve_integrals-inl.h) the support cuts the ring at an angle μ, sin²(μ/2) = S/2a, with
//   W² = ρ² sin²μ = (S/R)(ρ − S/4R),
// concave in S and rising with ρ, so its least value on a stretch is at a corner of their ranges. Half the angle within
// the support is μ = 2 arcsin √σ ≤ 2√σ(1 + (π/2 − 1)σ), σ = S/2a (arcsin x/x is convex in x²). From its nearest point
// the squared distance grows by 4Rρ sin²(φ/2) ≥ (4ρ/π²R)(Rφ)².
#if defined(ISL_RENDERER_FIELDS_CONVOLUTIONS_RING_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_CONVOLUTIONS_RING_LANES_INL_H_
#undef ISL_RENDERER_FIELDS_CONVOLUTIONS_RING_LANES_INL_H_
#else
#define ISL_RENDERER_FIELDS_CONVOLUTIONS_RING_LANES_INL_H_
#endif

#include "renderer/fields/convolutions/curve_point-inl.h"
#include "renderer/fields/convolutions/curve_remainder-inl.h"
#include "renderer/fields/convolutions/ring_cauchy-inl.h"
#include "renderer/fields/convolutions/ring_quartic-inl.h"
#include "renderer/fields/skeletons/circle.h"
#include "renderer/fields/skeletons/ray_form-inl.h"

#include <array>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct RingLanes {
  static constexpr std::size_t kAlong = 5, kShape = 1;
  Octet z0, dz;
  Octet n0, n2, middle;
  Octet ring_radius, amplitude;

  template <class N>
  [[nodiscard]] static HWY_INLINE std::array<N, kAlong> along(const Circle& ring, double per_unit,
                                                              const Lines<N>& lines) {
    const AboutAxis<N> line = about_axis(ring.centre, ring.axis, lines);
    const N unit(per_unit), unit2 = unit * unit;
    return {line.x0 * unit, line.dx * unit, line.n0 * unit2, line.n2 * unit2, line.middle};
  }
  [[nodiscard]] static std::array<double, kShape> shape(const Circle& ring, double unit) {
    return {ring.ring_radius * unit};
  }
  static constexpr std::array<double, kAlong + kShape> kOutOfReach = {kFarAway, 1, 1, 0, 0, 1};

  /// |D|.
  [[nodiscard]] HWY_INLINE Octet speed() const { return sqrt(dz * dz + n2); }

  template <class Window>
  [[nodiscard]] HWY_INLINE CurvePoint at(const Window& window, const Octet& t, const Octet& size) const {
    const Octet two(2.0), tau = t - middle, rise = n2 * tau, z = z0 + dz * t;
    const Octet rho = sqrt(n0 + rise * tau), across = rho - ring_radius;
    const RingView<Octet> view{ring_radius, rho, across * across + z * z};
    const RingIntegrals<Octet> f = integrate(window, view);
    const OctetMask active = view.distance2 < Octet(1.0);
    const Octet weight = abs(amplitude), along = rise + z * dz;  // p·D
    return {keep(active, amplitude * f.value), keep(active, two * amplitude * (rise * f.radial - along * f.whole)),
            keep(active, weight * f.value_terms),
            keep(active, two * weight * (abs(rise) * f.radial_terms + (abs(rise) + abs(z * dz)) * f.whole_terms)),
            keep(active, two * weight * size * f.whole)};
  }

  /// Upper bound of the value on the stretch, for amplitude 1: the value at the least distance and the least ρ, for
  /// which the squared distance, d² + 2Rρ(1 − cos φ), grows least along the ring. Positions may be off by `error`.
  template <class Window>
  [[nodiscard]] HWY_INLINE Octet most(const Window& window, const Octet& t0, const Octet& t1,
                                      const Octet& error) const {
    const Ranges r = ranges(t0, t1, error);
    const RingView<Octet> view{ring_radius, r.rho_low, r.y_low};
    const RingIntegrals<Octet> f = integrate(window, view);
    return keep(r.y_low < Octet(1.0), f.value + Octet(0x1p-48) * f.value_terms);
  }

  /// Lower bound likewise: the value at the greatest distance and the greatest ρ.
  template <class Window>
  [[nodiscard]] HWY_INLINE Octet least(const Window& window, const Octet& t0, const Octet& t1,
                                       const Octet& error) const {
    const Ranges r = ranges(t0, t1, error);
    const RingIntegrals<Octet> f = integrate(window, RingView<Octet>{ring_radius, r.rho_high, r.y_high});
    return keep(r.y_high < Octet(1.0), max(Octet(0.0), f.value - Octet(0x1p-48) * f.value_terms));
  }

  [[nodiscard]] HWY_INLINE CurveStretch stretch(const Octet& t0, const Octet& t1) const {
    const Octet zero(0.0), one(1.0), four(4.0);
    const Ranges r = ranges(t0, t1, zero);
    const Octet s_high = one - r.y_low, s_low = one - r.y_high;
    const Octet least(1e-300);
    const Octet sigma = min(one, s_high / max(four * ring_radius * r.rho_low, least));
    CurveStretch result;
    result.y_least = r.y_low;
    result.length = two_pi_times(ring_radius) *
                    min(one, Octet(2 / kPi) * sqrt(max(sigma, zero)) * (one + Octet(kPi / 2 - 1) * sigma));
    result.spread = Octet(kPi / 2) * sqrt(ring_radius / max(r.rho_low, least));
    result.speed2 = dz * dz + n2;
    result.e2 = result.speed2;  // the distance within the support is below 1
    result.tangent = sqrt(n2);
    const Octet most = sqrt(result.speed2);
    const auto width2 = [&](const Octet& s)
                            HWY_ATTR { return s / ring_radius * (r.rho_low - Octet(0.25) * s / ring_radius); };
    const OctetMask never = s_low >= four * ring_radius * r.rho_high;
    const OctetMask always = (s_low > zero) & (s_high < four * ring_radius * r.rho_low);
    CutBounds cut;
    cut.may_be = s_low < four * ring_radius * r.rho_high;
    cut.stays = never | always;
    cut.width2 = min(width2(max(s_low, zero)), width2(s_high));
    cut.e_low = zero - most;
    cut.e_high = most;
    cut.bend = r.rho_high / ring_radius;
    result.cuts[0] = result.cuts[1] = cut;
    return result;
  }

 private:
  struct Ranges {
    Octet rho_low, rho_high;
    Octet y_low, y_high;  ///< squared distance to the ring
  };
  [[nodiscard]] HWY_INLINE Ranges ranges(const Octet& t0, const Octet& t1, const Octet& error) const {
    const Octet zero(0.0);
    const Octet za = z0 + dz * t0, zb = z0 + dz * t1;
    const Octet z_near = max(zero, max(min(za, zb), zero - max(za, zb))), z_far = max(abs(za), abs(zb));
    const Octet a = t0 - middle, b = t1 - middle;
    const Octet near = max(zero, max(a, zero - b)), far = max(abs(a), abs(b));
    Ranges r;
    r.rho_low = max(zero, sqrt(n0 + n2 * near * near) - error);
    r.rho_high = sqrt(n0 + n2 * far * far) + error;
    const Octet gap = max(zero, max(r.rho_low - ring_radius, ring_radius - r.rho_high));
    const Octet spread = max(abs(r.rho_high - ring_radius), abs(ring_radius - r.rho_low));
    const Octet nearest = max(zero, sqrt(gap * gap + z_near * z_near) - error);
    const Octet farthest = sqrt(spread * spread + z_far * z_far) + error;
    r.y_low = nearest * nearest;
    r.y_high = farthest * farthest;
    return r;
  }
  [[nodiscard]] static HWY_INLINE Octet two_pi_times(const Octet& radius) { return Octet(2 * kPi) * radius; }
};

template <>
struct CurveFormOf<Circle> {
  using type = RingLanes;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
