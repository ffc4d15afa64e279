// Eight circles (skeletons/circle.h) along a ray. With z = z₀ + z′t and n = ρ² = n₀ + n₂τ², τ = t − tₙ, w = qr² = (ρ −
// R)² + z²:
//
//   w′ = 2zz′ + 2n₂τ(1 − R/ρ),  w″ = 2(z′² + n₂) − 2Rρ″,  w‴ = −2Rρ‴,  w⁗ = −2Rρ⁗
//   ρ″ = n₀n₂/ρ³,  ρ‴ = −3n₀n₂²τ/ρ⁵,  ρ⁗ = n₀n₂²(12ρ² − 15n₀)/ρ⁷
//
// Bounds: |w′| ≤ 2√w|D| (a distance changes no faster than the point moves); with n₂τ² ≤ ρ² and |12x − 15x²| ≤ 3 for
// x = n₀/ρ² in [0, 1], |w‴| ≤ 6R n₀n₂√n₂/ρ⁴ and |w⁗| ≤ 6R n₂²/ρ³. ρ is taken no smaller than it is within the support.
#if defined(ISL_RENDERER_FIELDS_SKELETONS_CIRCLE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_SKELETONS_CIRCLE_LANES_INL_H_
#undef ISL_RENDERER_FIELDS_SKELETONS_CIRCLE_LANES_INL_H_
#else
#define ISL_RENDERER_FIELDS_SKELETONS_CIRCLE_LANES_INL_H_
#endif

#include "renderer/fields/kernels/kernel_bounds-inl.h"
#include "renderer/fields/skeletons/lane_point-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct CircleBounds {
  JetBounds v;
  OctetMask one_piece;  ///< everywhere
  Octet least, greatest;

  template <class Kernel>
  [[nodiscard]] HWY_INLINE SecondAndFourth compose(const Kernel& kernel) const {
    return render::HWY_NAMESPACE::compose(kernel, v);
  }
  /// |f′| on the interval is no greater.
  template <class Kernel>
  [[nodiscard]] HWY_INLINE Octet steepest(const Kernel& kernel) const {
    return kernel.slopes(v.least).first * v.first;
  }
};

struct CircleLanes {
  Octet z0, dz, n0, n2, middle, ring_radius, inverse_radius2, amplitude;

  [[nodiscard]] HWY_INLINE LanePoint at(const Octet& t, double scale) const {
    const Octet z = z0 + dz * t, tau = t - middle, n2_tau = n2 * tau;
    const Octet rho = radius_at(tau), across = rho - ring_radius;
    const Octet factor = Octet(scale) * inverse_radius2;
    return {factor * (across * across + z * z), factor * Octet(2.0) * (z * dz + n2_tau * (across / rho))};
  }

  /// v″.
  [[nodiscard]] HWY_INLINE Octet second(const Octet& t, double scale) const {
    const Octet rho = radius_at(t - middle);
    const Octet bend = ring_radius * n0 * n2 / (rho * rho * rho);
    return Octet(2 * scale) * inverse_radius2 * (dz * dz + n2 - bend);
  }

  [[nodiscard]] HWY_INLINE CircleBounds bounds(const Octet& t0, const Octet& t1, double scale, double support) const {
    const Octet zero(0.0);
    const Octet za = z0 + dz * t0, zb = z0 + dz * t1;
    const Octet z_near = max(zero, max(min(za, zb), zero - max(za, zb))), z_far = max(abs(za), abs(zb));
    const Octet a = t0 - middle, b = t1 - middle;
    const Octet near = max(zero, max(a, zero - b)), far = max(abs(a), abs(b));
    const Octet rho_low = radius_at(near), rho_high = radius_at(far);
    const Octet outer = rho_high - ring_radius, inner = ring_radius - rho_low;
    const Octet gap = max(zero, max(rho_low - ring_radius, ring_radius - rho_high));
    const Octet spread = max(abs(outer), abs(inner));
    const Octet factor = Octet(scale) * inverse_radius2;

    CircleBounds result;
    result.one_piece = zero < Octet(1.0);
    result.least = result.v.least = factor * (gap * gap + z_near * z_near);
    result.greatest = factor * (spread * spread + z_far * z_far);
    // Beyond the support nothing counts, neither its greater distances nor a smaller ρ.
    const Octet reach2 = Octet(support) / factor;
    const Octet w_most = min(result.greatest / factor, reach2);
    const Octet rho = max(rho_low, ring_radius - sqrt(reach2));
    const Octet rho3 = rho * rho * rho, speed2 = dz * dz + n2;
    result.v.first = factor * Octet(2.0) * sqrt(w_most * speed2);
    result.v.second_high = factor * Octet(2.0) * speed2;
    result.v.second_low = factor * Octet(2.0) * (speed2 - ring_radius * n0 * n2 / rho3);
    result.v.third = factor * Octet(6.0) * ring_radius * n0 * n2 * sqrt(n2) / (rho3 * rho);
    result.v.fourth = factor * Octet(6.0) * ring_radius * n2 * n2 / rho3;
    return result;
  }

 private:
  [[nodiscard]] HWY_INLINE Octet radius_at(const Octet& tau) const { return sqrt(n0 + n2 * tau * tau); }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
