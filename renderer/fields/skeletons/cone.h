// The round cone. In the half-plane through its axis, x along it from end a and ρ from it, there is a sphere of
// radius r(u) = r₀ + ku at every u in [0, L]; the field's argument is that of the nearest sphere,
//
//   q(x, ρ) = min over u of ((x − u)² + ρ²) / r(u)².
//
// With w = r(x) = r₀ + kx and s = 1/r(u): (x − u)/r(u) = (ws − 1)/k, so that k²·(…) = (ws − 1)² + k²ρ²s², a convex
// quadratic in s with its minimum at s* = w/(w² + k²ρ²). Hence u* = x + kρ²/w and q = ρ²/(w² + k²ρ²) where that lies in
// [0, L]; elsewhere the nearer end in s (for w ≤ 0, beyond the apex, the thick end). q is C¹ across the borders, since
// u only stops at an end. The sets q ≤ c are convex (hulls of two spheres), so q is quasi-convex, with its least value
// on any line parallel to the axis at the point nearest to the thick end. Along a ray q is not a polynomial, so the
// cone has a ray form.
//
// Record: the ends a and b, radius_a at a and radius_b at b.
#ifndef ISL_RENDERER_FIELDS_SKELETONS_CONE_H_
#define ISL_RENDERER_FIELDS_SKELETONS_CONE_H_

#include "renderer/fields/skeletons/skeleton.h"

namespace isl::render {

struct Cone {
  Cone(const scene::Blob&, const scene::Component& c) : a(c.a), length((c.b - c.a).length()), radius(c.radius_a) {
    axis = (c.b - c.a) / length;
    slope = (c.radius_b - c.radius_a) / length;
  }

  Vec3 a;         ///< the end at u = 0
  Vec3 axis;      ///< unit
  double length;  ///< L > 0
  double radius;  ///< r₀ ≥ 0
  double slope;   ///< k

  [[nodiscard]] double radius_at(double u) const { return std::max(radius + slope * u, 0.0); }
  [[nodiscard]] double thick_end() const { return slope > 0 ? length : 0; }

  /// u of the sphere that is nearest to (x, ρ) in the measure of q.
  [[nodiscard]] double nearest(double x, double rho2) const noexcept {
    const double w = radius + slope * x;
    if (!(w > 0)) return thick_end();
    return std::clamp(x + slope * rho2 / w, 0.0, length);
  }

  [[nodiscard]] double q(double x, double rho2) const noexcept {
    const double u = nearest(x, rho2);
    const double r = radius_at(u);
    return ((x - u) * (x - u) + rho2) / (r * r);
  }

  [[nodiscard]] Foot nearest(const Vec3& p) const {
    const Vec3 from_a = p - a;
    const double x = from_a.dot(axis);
    const double u = nearest(x, (from_a - axis * x).length2());
    const double r = radius_at(u);
    return {from_a - axis * u, 1 / (r * r)};
  }

  /// Computed from the rectangle in (x, ρ) that contains the box.
  [[nodiscard]] QRange q_over(const Box& box) const {
    const AxialRange range(box, a, axis);
    const double nearest_x = std::clamp(thick_end(), range.x_low, range.x_high);
    const double rho2_low = range.rho_low * range.rho_low, rho2_high = range.rho_high * range.rho_high;
    return {q(nearest_x, rho2_low), std::max(q(range.x_low, rho2_high), q(range.x_high, rho2_high))};
  }

  /// First coordinate: position of the nearest sphere, 0 at a and 1 at b. Second: share of a turn around the axis, from
  /// AcrossAxis' x.
  [[nodiscard]] Coordinates coordinates(const Vec3& p, const scene::Turn& turn) const {
    const Vec3 from_a = p - a;
    const double x = from_a.dot(axis);
    const AcrossAxis across(turn.back(axis));
    return {nearest(x, (from_a - axis * x).length2()) / length, across.share_of_turn(turn.back(from_a))};
  }

  [[nodiscard]] Vec3 middle() const { return a + axis * (0.5 * length); }
  [[nodiscard]] double extent() const { return 0.5 * length; }
  [[nodiscard]] double thickest() const { return std::max(radius, radius_at(length)); }
  [[nodiscard]] double thinnest() const { return std::min(radius, radius_at(length)); }
  [[nodiscard]] std::array<Reach, 2> reach(const Vec3& n) const {
    const double at_a = n.dot(a);
    return {Reach{at_a, radius}, Reach{at_a + n.dot(axis) * length, radius_at(length)}};
  }

  class OnRay;
};

/// A set q ≤ c is the convex hull of two spheres. The ends of a ray's interval in it lie on one of the spheres, or on
/// the cone between them, where
///   ρ² / (w² + k²ρ²) = c   ⇔   (1 − ck²) ρ² = c w²,
/// and on the cone, q is least at (ρ²)′ w = 2 w′ ρ², an equation that is linear in t along a ray.
class Cone::OnRay {
 public:
  OnRay(const Cone& cone, const Vec3& origin, const Vec3& direction) : cone_(cone) {
    dd_ = direction.length2();
    centre_ = (cone.a + cone.axis * (0.5 * cone.length) - origin).dot(direction) / dd_;
    direction_ = direction;
    from_a_ = origin + direction * centre_ - cone.a;
    x_ = from_a_.dot(cone.axis);
    dx_ = direction.dot(cone.axis);
    across_ = from_a_ - cone.axis * x_;
    by_ = direction - cone.axis * dx_;
    w_ = cone.radius + cone.slope * x_;
  }

  /// The interval where q < c.
  [[nodiscard]] RayInterval below(double c) const {
    RayInterval found;
    for (const double u : {0.0, cone_.length}) {
      const Vec3 from_end = from_a_ - cone_.axis * u;
      const double r = cone_.radius_at(u), middle = -from_end.dot(direction_) / dd_;
      const double half2 = (c * r * r - (from_end + direction_ * middle).length2()) / dd_;
      if (!(half2 > 0)) continue;
      found.extend(centre_ + (middle - std::sqrt(half2)));
      found.extend(centre_ + (middle + std::sqrt(half2)));
    }
    const double k = cone_.slope, share = 1 - c * k * k;
    if (!(share > 0)) return found;  // the thick sphere contains everything else
    // p₂ t² + 2 p₁ t + p₀ < 0
    const double p2 = share * by_.length2() - c * k * k * dx_ * dx_;
    const double p1 = share * by_.dot(across_) - c * k * dx_ * w_;
    const double p0 = share * across_.length2() - c * w_ * w_;
    const double discriminant = p1 * p1 - p2 * p0;
    if (!(discriminant > 0)) return found;
    const double sum = -(p1 + std::copysign(std::sqrt(discriminant), p1));
    for (const double t : {sum / p2, p0 / sum}) {
      const double w = w_ + k * dx_ * t, u = x_ + dx_ * t + k * (across_ + by_ * t).length2() / w;
      if (w > 0 && u >= 0 && u <= cone_.length) found.extend(centre_ + t);
    }
    return found;
  }

  /// The least q on the line.
  [[nodiscard]] double least() const {
    double least = std::numeric_limits<double>::infinity();
    for (const double u : {0.0, cone_.length}) {
      const Vec3 from_end = from_a_ - cone_.axis * u;
      const double r = cone_.radius_at(u), middle = -from_end.dot(direction_) / dd_;
      if (r > 0) least = std::min(least, (from_end + direction_ * middle).length2() / (r * r));
    }
    const double k = cone_.slope, middle = -by_.dot(across_) / by_.length2();
    const double p = (across_ + by_ * middle).length2(), w_there = w_ + k * dx_ * middle;
    const double t = middle + k * dx_ * p / (by_.length2() * w_there);
    const double w = w_ + k * dx_ * t, rho2 = (across_ + by_ * t).length2(), u = x_ + dx_ * t + k * rho2 / w;
    if (w > 0 && u >= 0 && u <= cone_.length) least = std::min(least, rho2 / (w * w + k * k * rho2));
    return least;
  }

 private:
  const Cone& cone_;
  Vec3 direction_, from_a_, across_, by_;
  double dd_, centre_, x_, dx_, w_;
};

}  // namespace isl::render

#endif  // ISL_RENDERER_FIELDS_SKELETONS_CONE_H_

// The ray form: eight round cones along one ray, or one cone along eight rays. With w = r₀ + kx, N = ρ² and
// M = w² + k²N, all polynomials of t:
//
//   u* = x + kN/w in [0, L]:  q = N/M, so that  q′ = (N′ − qM′)/M,  q″ = (N″ − 2q′M′ − qM″)/M,
//                             q‴ = −3(q″M′ + q′M″)/M,  q⁗ = −(4q‴M′ + 6q″M″)/M        (differentiate qM = N)
//   otherwise an end:          q = ((x − u)² + N)/r(u)², a quadratic.
//
// Values take the nearest sphere u directly: q = ((x − u)² + N)/r², and since u either minimises q or is fixed,
// q′ = (2(x − u)x′ + N′)/r² (the envelope theorem). There are bounds for each of the three pieces (two ends and
// the body) that an interval can touch. If it certainly touches only one of them, f is smooth on the interval.
#ifdef ISL_RAY_FORMS  // renderer/fields/skeletons/ray_forms-inl.h
HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct ConeBounds {
  JetBounds at_a, at_b, body;
  OctetMask may_a, may_b, may_body;
  OctetMask one_piece;
  Octet least, greatest;  ///< range of v
  Octet factor;           ///< as in ShapeBounds

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
  /// Upper bound of |f′| on the interval.
  template <class Kernel>
  [[nodiscard]] HWY_INLINE Octet steepest(const Kernel& kernel) const {
    const auto of = [&](const JetBounds& v) HWY_ATTR { return kernel.slopes(v.least).first * v.first; };
    return max(keep(may_a, of(at_a)), max(keep(may_b, of(at_b)), keep(may_body, of(body))));
  }
};

struct ConeLanes {
  static constexpr std::size_t kAlong = 5, kShape = 3;
  Octet x0, dx, n0, n2, middle;
  Octet radius, k, length;
  Octet amplitude;

  template <class N>
  [[nodiscard]] static HWY_INLINE std::array<N, kAlong> along(const Cone& cone, const Lines<N>& lines) {
    const AboutAxis<N> line = about_axis(cone.a, cone.axis, lines);
    return {line.x0, line.dx, line.n0, line.n2, line.middle};
  }
  [[nodiscard]] static std::array<double, kShape> shape(const Cone& cone) {
    return {cone.radius, cone.slope, cone.length};
  }
  static constexpr std::array<double, kAlong + kShape> kOutOfReach = {
      0, 0, std::numeric_limits<double>::infinity(), 0, 0, 1, 0, 0};

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
    return {factor * (e * e + n), factor * (Octet(2.0) * (e * dx + n2 * tau)), factor};
  }

  /// v″ on the piece that contains t.
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

    // Compares u* = (xw + kN)/w with 0 and L, by the corners of the ranges of x and w.
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
    // Also |q′| = 2√q |(p − c)·D|/(|p − c| r) ≤ 2√q |D|/r, and the radius r of the nearest sphere is not below
    // r(x) nor that of the thin end; q beyond the support is irrelevant.
    const Octet r_low = max(w_from, min(radius, radius + k * length));
    result.factor = Octet(scale) / max(r_low * r_low, Octet(kLeast));
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
    // q is at most its value for any single sphere. The bound takes the least of three: the sphere that is nearest to
    // the interval's midpoint, which is almost tight on short intervals, and those at the two ends, unless their radius
    // is 0.
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
  /// Limits that keep products of bounds finite if the interval contains the cone's apex (M = 0). Bounds of that size
  /// are of no use, so the interval is subdivided there.
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

template <>
struct RayFormOf<Cone> {
  using type = ConeLanes;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();
#endif  // ISL_RAY_FORMS
