// The disc (a round plate with a rounded rim): q = (z² + g²)/r² with g = max(ρ − R, 0), z along the axis from the
// disc's centre and ρ from the axis. Over the disc q measures the distance from its plane, beyond the rim that from a
// circle. It is C¹ across the rim's cylinder ρ = R, where g and so ∇g² = 2g∇g vanish. A disc is convex, and so is the
// squared distance to it; on the axis there is no crease, since g = 0 about it. Along a ray q is not a polynomial
// beyond the rim, so the disc has a ray form.
//
// Record: the centre a, the unit axis b, R = radius_b, r = radius_a.
#ifndef ISL_RENDERER_FIELDS_SKELETONS_DISC_H_
#define ISL_RENDERER_FIELDS_SKELETONS_DISC_H_

#include "renderer/fields/skeletons/skeleton.h"

namespace isl::render {

struct Disc {
  Disc(const scene::Blob&, const scene::Component& c)
      : centre(c.a), axis(c.b), disc_radius(c.radius_b), radius(c.radius_a) {}

  Vec3 centre;
  Vec3 axis;  ///< unit
  double disc_radius, radius;

  [[nodiscard]] Foot nearest(const Vec3& p) const {
    const Vec3 from_centre = p - centre;
    const double z = from_centre.dot(axis);
    const Vec3 across = from_centre - axis * z;
    const double rho = across.length();
    const double share_beyond = rho > disc_radius ? 1 - disc_radius / rho : 0;
    return {axis * z + across * share_beyond, 1 / (radius * radius)};
  }

  /// Computed from the rectangle in (z, ρ) that contains the box.
  [[nodiscard]] QRange q_over(const Box& box) const {
    const AxialRange range(box, centre, axis);
    const double z_near = std::max({range.x_low, -range.x_high, 0.0}), z_far = std::max(-range.x_low, range.x_high);
    const double g_near = std::max(range.rho_low - disc_radius, 0.0),
                 g_far = std::max(range.rho_high - disc_radius, 0.0);
    const double inverse_radius2 = 1 / (radius * radius);
    return {inverse_radius2 * (z_near * z_near + g_near * g_near), inverse_radius2 * (z_far * z_far + g_far * g_far)};
  }

  /// Coordinates of the nearest point. First: 0 at the centre, 1 at the rim. Second: share of a turn around the axis,
  /// from AcrossAxis' x.
  [[nodiscard]] Coordinates coordinates(const Vec3& p, const scene::Turn&) const {
    const Vec3 from_centre = p - centre;
    const double rho = (from_centre - axis * from_centre.dot(axis)).length();
    return {std::min(rho / disc_radius, 1.0), AcrossAxis(axis).share_of_turn(from_centre)};
  }

  [[nodiscard]] const Vec3& middle() const { return centre; }
  [[nodiscard]] double extent() const { return disc_radius; }
  [[nodiscard]] double thickest() const { return radius; }
  [[nodiscard]] std::array<Reach, 2> reach(const Vec3& n) const {
    const double coordinate = n.dot(centre) + disc_radius * n.cross(axis).length();
    return {Reach{coordinate, radius}, Reach{coordinate, radius}};
  }

  class OnRay;
};

/// q is convex along a ray. Bisection by the sign of q′ finds its minimum; two more, from there outwards, find the ends
/// of the interval q < c. The error of a position is 2⁻⁶⁰ of the stretch that is searched, less than its rounding.
class Disc::OnRay {
 public:
  OnRay(const Disc& disc, const Vec3& origin, const Vec3& direction)
      : disc_(disc), origin_(origin), direction_(direction) {
    const double dd = direction.length2();
    middle_ = (disc.centre - origin).dot(direction) / dd;
    // Beyond this stretch a point is farther than any point of the disc from the plane through the centre that is
    // perpendicular to the ray, so q rises outwards.
    const double half = disc.disc_radius / std::sqrt(dd);
    double falls = middle_ - half, rises = middle_ + half;
    for (int i = 0; i < kHalvings; ++i) {
      const double t = 0.5 * (falls + rises);
      (at(t).offset.dot(direction) < 0 ? falls : rises) = t;
    }
    lowest_ = 0.5 * (falls + rises);
  }

  /// The interval where q < c.
  [[nodiscard]] RayInterval below(double c) const {
    if (!(least() < c)) return {};
    // Points farther than this from the middle have q ≥ c: their distance from the disc is at least √c r.
    const double half = (disc_.disc_radius + std::sqrt(c) * disc_.radius) / direction_.length();
    return {border(c, middle_ - half), border(c, middle_ + half)};
  }

  /// The least q on the line.
  [[nodiscard]] double least() const { return at(lowest_).q(); }

 private:
  static constexpr int kHalvings = 60;

  [[nodiscard]] Foot at(double t) const { return disc_.nearest(origin_ + direction_ * t); }
  [[nodiscard]] double border(double c, double outer) const {
    double inner = lowest_;
    for (int i = 0; i < kHalvings; ++i) {
      const double t = 0.5 * (inner + outer);
      (at(t).q() < c ? inner : outer) = t;
    }
    return inner;
  }

  const Disc& disc_;
  Vec3 origin_, direction_;
  double middle_, lowest_;
};

}  // namespace isl::render

#endif  // ISL_RENDERER_FIELDS_SKELETONS_DISC_H_

// The ray form: eight discs along one ray, or one disc along eight rays. With z = z₀ + z′t, ρ² = n₀ + n₂τ², τ = t − tₙ,
// w = qr² = z² + g²:
//
//   over the disc (ρ ≤ R)   w′ = 2zz′,                  w″ = 2z′²
//   beyond its rim          w′ = 2zz′ + 2n₂τ(1 − R/ρ),  w″ = 2(z′² + n₂) − 2Rρ″,  w‴ = −2Rρ‴,  w⁗ = −2Rρ⁗
//   ρ″ = n₀n₂/ρ³,  ρ‴ = −3n₀n₂²τ/ρ⁵,  ρ⁗ = n₀n₂²(12ρ² − 15n₀)/ρ⁷
//
// Bounds: with |ρ′| ≤ √n₂, |w′| ≤ 2|z z′| + 2g√n₂, and no more than 2√w|D| (a distance changes no faster than the point
// moves). Beyond the rim n₀ ≤ ρ² and R ≤ ρ make 0 ≤ Rρ″ ≤ n₂, falling with ρ: so 2z′² ≤ w″ ≤ 2(z′² + n₂) on either side
// and across the rim. There, with n₂τ² ≤ ρ² and |12x − 15x²| ≤ 3 for x = n₀/ρ² in [0, 1], |w‴| ≤ 6R n₀n₂√n₂/ρ⁴ and |w⁗|
// ≤ 6R n₂²/ρ³; over the disc both are 0. w″ jumps at the rim, so f is smooth on either side only.
#ifdef ISL_RAY_FORMS  // renderer/fields/skeletons/ray_forms-inl.h
HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct DiscLanes {
  static constexpr std::size_t kAlong = 5, kShape = 2;
  Octet z0, dz, n0, n2, middle;
  Octet disc_radius, inverse_radius2;
  Octet amplitude;

  template <class N>
  [[nodiscard]] static HWY_INLINE std::array<N, kAlong> along(const Disc& disc, const Lines<N>& lines) {
    const AboutAxis<N> line = about_axis(disc.centre, disc.axis, lines);
    return {line.x0, line.dx, line.n0, line.n2, line.middle};
  }
  [[nodiscard]] static std::array<double, kShape> shape(const Disc& disc) {
    return {disc.disc_radius, 1 / (disc.radius * disc.radius)};
  }
  static constexpr std::array<double, kAlong + kShape> kOutOfReach = {kFarAway, 0, 1, 0, 0, 1, 1};

  [[nodiscard]] HWY_INLINE LanePoint at(const Octet& t, double scale) const {
    const Octet z = z0 + dz * t, tau = t - middle, n2_tau = n2 * tau;
    const Octet rho = sqrt(n0 + n2_tau * tau), g = beyond_rim(rho);
    const Octet factor = Octet(scale) * inverse_radius2;
    // g/ρ where g > 0; elsewhere 0/R, since ρ can be 0 on the axis.
    return {factor * (z * z + g * g), factor * Octet(2.0) * (z * dz + n2_tau * (g / max(rho, disc_radius))), factor};
  }

  /// v″ on the side of the rim on which t lies.
  [[nodiscard]] HWY_INLINE Octet second(const Octet& t, double scale) const {
    const Octet tau = t - middle, rho = sqrt(n0 + n2 * tau * tau);
    const Octet across = keep(rho > disc_radius, n2 - rim_bend(rho));
    return Octet(2 * scale) * inverse_radius2 * (dz * dz + across);
  }

  [[nodiscard]] HWY_INLINE ShapeBounds bounds(const Octet& t0, const Octet& t1, double scale, double support) const {
    const Octet zero(0.0), two(2.0), six(6.0);
    const Octet za = z0 + dz * t0, zb = z0 + dz * t1;
    const Octet z_near = max(zero, max(min(za, zb), zero - max(za, zb))), z_far = max(abs(za), abs(zb));
    const Octet a = t0 - middle, b = t1 - middle;
    const Octet near = max(zero, max(a, zero - b)), far = max(abs(a), abs(b));
    const Octet rho_low = sqrt(n0 + n2 * near * near), rho_high = sqrt(n0 + n2 * far * far);
    const Octet g_near = beyond_rim(rho_low), g_far = beyond_rim(rho_high);
    const Octet factor = Octet(scale) * inverse_radius2;
    const OctetMask over_disc = rho_high <= disc_radius, beyond = rho_low > disc_radius;

    ShapeBounds result;
    result.one_piece = over_disc | beyond;
    result.least = result.v.least = factor * (z_near * z_near + g_near * g_near);
    result.greatest = factor * (z_far * z_far + g_far * g_far);
    result.factor = factor;
    // Distances beyond the support are irrelevant, so greater ones are cut off.
    const Octet dz2 = dz * dz, root_n2 = sqrt(n2);
    const Octet w_most = min(result.greatest, Octet(support)) / factor;
    result.v.first = factor * two * min(z_far * abs(dz) + g_far * root_n2, sqrt(w_most * (dz2 + n2)));
    // The least ρ on the part of the stretch beyond the rim, if there is such a part.
    const Octet rho = max(rho_low, disc_radius), rho3 = rho * rho * rho;
    const auto beyond_only = [&](const Octet& x) HWY_ATTR { return select(over_disc, zero, x); };
    result.v.second_low = factor * two * (dz2 + keep(beyond, max(zero, n2 - rim_bend(rho))));
    result.v.second_high = factor * two * (dz2 + beyond_only(n2 - rim_bend(rho_high)));
    result.v.third = factor * beyond_only(six * disc_radius * n0 * n2 * root_n2 / (rho3 * rho));
    result.v.fourth = factor * beyond_only(six * disc_radius * n2 * n2 / rho3);
    return result;
  }

 private:
  [[nodiscard]] HWY_INLINE Octet beyond_rim(const Octet& rho) const { return max(rho - disc_radius, Octet(0.0)); }
  /// Rρ″.
  [[nodiscard]] HWY_INLINE Octet rim_bend(const Octet& rho) const { return disc_radius * n0 * n2 / (rho * rho * rho); }
};

template <>
struct RayFormOf<Disc> {
  using type = DiscLanes;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif  // ISL_RAY_FORMS
