// Point, segment and cone: the least of |o − ue|²/r(u)² for u from 0 to 1, with o = p − a, e = b − a, r = r_a + uΔr.
// With v = o·e/E and E = e·e, ρ² = |o − ve|² and the radius A = r_a + vΔr at the foot, the derivative of (E(u − v)² +
// ρ²)/r² with respect to u has the sign of (u − v)EA − Δrρ². So where A > 0 the nearest sphere is at u* = v +
// Δrρ²/(EA), where the quotient is ρ²/(A² + (Δr²/E)ρ²), or at the end that is nearest to u*; behind the apex, A ≤ 0, it
// is the thicker end.
#include "renderer/reference/distances.h"

#include <optional>

namespace isl::ISL_REFERENCE {
namespace {

class Cone {
 public:
  Cone(const scene::Component& c)
      : a_(interval_of(c.a)), b_(interval_of(c.b)), e_(b_ - a_), length2_(squared_length(e_)), r_(c.radius_a) {
    step_ = Interval(c.radius_b) - r_;
    a_factor_ = c.radius_a > 0 ? std::optional(Interval(1) / square(r_)) : std::nullopt;
    b_factor_ = c.radius_b > 0 ? std::optional(Interval(1) / square(Interval(c.radius_b))) : std::nullopt;
  }

  [[nodiscard]] Jet operator()(const Vector<Jet>& p) const {
    if (length2_.lo() <= 0) return step_.sign() > 0 ? end(b_, b_factor_, p) : end(a_, a_factor_, p);
    const Vector<Jet> w = from(a_, p);
    const Jet v = dot(w, e_) * (Interval(1) / length2_);
    const Jet rho2 = squared_length(w - times(e_, v)), radius = v * step_ + r_;
    // u* of all places, or of none.
    std::optional<Interval> u;
    if (radius.value.sign() > 0) {
      u = v.value + step_ * rho2.value / (length2_ * radius.value);
    } else if (radius.value.hi() > 0) {
      // As the apex comes nearer, u* moves towards the thicker end and beyond.
      const Interval least = v.value + step_ * rho2.value / (length2_ * Interval(radius.value.hi()));
      u = step_.sign() > 0 ? Interval(least.lo(), kUnbounded) : Interval(-kUnbounded, least.hi());
    } else {
      u = step_.sign() > 0 ? kUnbounded : -kUnbounded;
    }
    std::optional<Jet> all;
    const auto may_be = [&](const Jet& one) { all = all ? hull(*all, one) : one; };
    // An end of radius zero is the nearest sphere of no place but itself.
    if (u->lo() < 0 && a_factor_) may_be(end(a_, a_factor_, p));
    if (u->hi() > 1 && b_factor_) may_be(end(b_, b_factor_, p));
    if (u->hi() >= 0 && u->lo() <= 1) may_be(flank(rho2, radius));
    return all ? *all : anything();
  }

 private:
  static Jet anything() {
    const Interval any = Interval::around(0, kUnbounded);
    return {positive_part(any), any, any};
  }
  static Jet end(const Vector<Interval>& centre, const std::optional<Interval>& factor, const Vector<Jet>& p) {
    return factor ? squared_length(from(centre, p)) * *factor : anything();
  }
  [[nodiscard]] Jet flank(const Jet& rho2, const Jet& radius) const {
    const Jet size = square(radius) + rho2 * (square(step_) / length2_);
    return size.value.sign() > 0 ? rho2 * inverse(size) : anything();
  }

  Vector<Interval> a_, b_, e_;
  Interval length2_, r_, step_;
  std::optional<Interval> a_factor_, b_factor_;
};

}  // namespace

SquaredDistance limb_distance(const scene::Component& c) {
  const Interval factor = Interval(1) / square(Interval(c.radius_a));
  const Vector<Interval> a = interval_of(c.a);
  if (c.skeleton == scene::Skeleton::point)
    return [=](const Vector<Jet>& p) { return squared_length(from(a, p)) * factor; };
  if (c.skeleton == scene::Skeleton::segment || c.radius_a == c.radius_b)
    return [=, segment = Segment(a, interval_of(c.b))](const Vector<Jet>& p) { return segment(p) * factor; };
  return Cone(c);
}

}  // namespace isl::ISL_REFERENCE
