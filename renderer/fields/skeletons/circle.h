// The circle (a torus): q = ((ρ − R)² + z²)/r², with z along the axis from the circle's centre and ρ from the axis. On
// the axis the distance has a crease, so the support must not reach it (the interpreter sees to that): R > r √Q. Along
// a ray q is not a polynomial, so the circle has a ray form.
//
// Record: the centre a, the unit axis b, R = radius_b, r = radius_a.
#ifndef ISL_RENDERER_FIELDS_SKELETONS_CIRCLE_H_
#define ISL_RENDERER_FIELDS_SKELETONS_CIRCLE_H_

#include "renderer/fields/skeletons/skeleton.h"

namespace isl::render {

struct Circle {
  Circle(const scene::Blob&, const scene::Component& c)
      : centre(c.a), axis(c.b), ring_radius(c.radius_b), radius(c.radius_a) {}

  Vec3 centre;
  Vec3 axis;  ///< unit
  double ring_radius, radius;

  [[nodiscard]] Foot nearest(const Vec3& p) const {
    const Vec3 from_centre = p - centre;
    const double z = from_centre.dot(axis);
    const Vec3 across = from_centre - axis * z;
    const double rho = across.length();
    if (rho == 0) return {axis * z + any_across() * ring_radius, 1 / (radius * radius)};
    return {axis * z + across * (1 - ring_radius / rho), 1 / (radius * radius)};
  }

  [[nodiscard]] QRange q_over(const Box& box) const {
    return q_range_by_distance(nearest(box.center()).q(), radius, box);
  }

  /// The coordinates of POV-Ray's torus, whose axis is y.
  [[nodiscard]] Coordinates coordinates(const Vec3& p, const scene::Turn&) const {
    const Vec3 from_centre = p - centre;
    const AcrossAxis across(axis);
    return torus_coordinates({from_centre.dot(across.x), from_centre.dot(axis), from_centre.dot(across.z)},
                             ring_radius);
  }

  [[nodiscard]] const Vec3& middle() const { return centre; }
  [[nodiscard]] double extent() const { return ring_radius; }
  [[nodiscard]] double thickest() const { return radius; }
  [[nodiscard]] std::array<Reach, 2> reach(const Vec3& n) const {
    const double coordinate = n.dot(centre) + ring_radius * n.cross(axis).length();
    return {Reach{coordinate, radius}, Reach{coordinate, radius}};
  }

 private:
  [[nodiscard]] Vec3 any_across() const {
    return axis.cross(std::abs(axis.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)).normalized();
  }
};

}  // namespace isl::render

#endif  // ISL_RENDERER_FIELDS_SKELETONS_CIRCLE_H_

// The ray form: eight circles along one ray, or one circle along eight rays. With z = z₀ + z′t and n = ρ² = n₀ + n₂τ²,
// τ = t − tₙ, w = qr² = (ρ − R)² + z²:
//
//   w′ = 2zz′ + 2n₂τ(1 − R/ρ),  w″ = 2(z′² + n₂) − 2Rρ″,  w‴ = −2Rρ‴,  w⁗ = −2Rρ⁗
//   ρ″ = n₀n₂/ρ³,  ρ‴ = −3n₀n₂²τ/ρ⁵,  ρ⁗ = n₀n₂²(12ρ² − 15n₀)/ρ⁷
//
// Bounds: |w′| ≤ 2√w|D| (a distance changes no faster than the point moves); with n₂τ² ≤ ρ² and |12x − 15x²| ≤ 3 for
// x = n₀/ρ² in [0, 1], |w‴| ≤ 6R n₀n₂√n₂/ρ⁴ and |w⁗| ≤ 6R n₂²/ρ³. ρ is taken no smaller than it is within the support.
#ifdef ISL_RAY_FORMS  // renderer/fields/skeletons/ray_forms-inl.h
HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct CircleLanes {
  static constexpr std::size_t kAlong = 5, kShape = 2;
  Octet z0, dz, n0, n2, middle;
  Octet ring_radius, inverse_radius2;
  Octet amplitude;

  template <class N>
  [[nodiscard]] static HWY_INLINE std::array<N, kAlong> along(const Circle& circle, const Lines<N>& lines) {
    const AboutAxis<N> line = about_axis(circle.centre, circle.axis, lines);
    return {line.x0, line.dx, line.n0, line.n2, line.middle};
  }
  [[nodiscard]] static std::array<double, kShape> shape(const Circle& circle) {
    return {circle.ring_radius, 1 / (circle.radius * circle.radius)};
  }
  static constexpr std::array<double, kAlong + kShape> kOutOfReach = {kFarAway, 0, 1, 0, 0, 1, 1};

  [[nodiscard]] HWY_INLINE LanePoint at(const Octet& t, double scale) const {
    const Octet z = z0 + dz * t, tau = t - middle, n2_tau = n2 * tau;
    const Octet rho = radius_at(tau), across = rho - ring_radius;
    const Octet factor = Octet(scale) * inverse_radius2;
    return {factor * (across * across + z * z), factor * Octet(2.0) * (z * dz + n2_tau * (across / rho)), factor};
  }

  /// v″.
  [[nodiscard]] HWY_INLINE Octet second(const Octet& t, double scale) const {
    const Octet rho = radius_at(t - middle);
    const Octet bend = ring_radius * n0 * n2 / (rho * rho * rho);
    return Octet(2 * scale) * inverse_radius2 * (dz * dz + n2 - bend);
  }

  [[nodiscard]] HWY_INLINE ShapeBounds bounds(const Octet& t0, const Octet& t1, double scale, double support) const {
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

    ShapeBounds result;
    result.one_piece = zero < Octet(1.0);
    result.least = result.v.least = factor * (gap * gap + z_near * z_near);
    result.greatest = factor * (spread * spread + z_far * z_far);
    result.factor = factor;
    // Points beyond the support are irrelevant, so greater distances and smaller ρ are cut off.
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

template <>
struct RayFormOf<Circle> {
  using type = CircleLanes;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();
#endif  // ISL_RAY_FORMS
