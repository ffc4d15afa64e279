// Circle and disc about the centre a, across the axis b, with the radius R. With w = p − a, h = w·b/|b| and ρ the
// length of the rest, r²q is (ρ − R)² + h² or max(ρ − R, 0)² + h². Of ρ along a line it is known, besides its formula,
// that it is convex and no faster than the line.
#include "renderer/reference/distances.h"

namespace isl::ISL_REFERENCE {
namespace {

/// √(|u|²) of a vector that changes linearly; where it may be zero, with a bend of any size.
Jet length_of(const Vector<Jet>& u) {
  const Jet squared = squared_length(u);
  const Interval speed2 = square(u.x.slope) + square(u.y.slope) + square(u.z.slope);
  const Interval root = square_root(squared.value);
  if (root.lo() <= 0) return {root, Interval::around(0, square_root(speed2).magnitude()), Interval(0, kUnbounded)};
  const Jet length = square_root(squared);
  return {length.value, length.slope, common(length.bend, Interval(Real(0), (speed2 / root).hi()))};
}

class Ring {
 public:
  Ring(const scene::Component& c)
      : centre_(interval_of(c.a)),
        axis_(interval_of(c.b)),
        axis2_(squared_length(axis_)),
        unit_(axis_ * (Interval(1) / axis2_)),
        ring_radius_(c.radius_b),
        factor_(Interval(1) / square(Interval(c.radius_a))),
        is_disc_(c.skeleton == scene::Skeleton::disc) {}

  [[nodiscard]] Jet operator()(const Vector<Jet>& p) const {
    const Vector<Jet> w = from(centre_, p);
    const Jet height = dot(w, unit_);
    const Jet along = square(height) * axis2_;
    const Jet beside = length_of(w - times(axis_, height)) - ring_radius_;
    if (!is_disc_) return (square(beside) + along) * factor_;
    Jet q = positive_square(beside) + along;
    // A disc is convex: the squared distance bends by no more than twice the squared speed.
    const Interval speed2 = square(p.x.slope) + square(p.y.slope) + square(p.z.slope);
    q.bend = common(q.bend, Interval(Real(0), 2 * speed2.hi()));
    return q * factor_;
  }

 private:
  Vector<Interval> centre_, axis_;
  Interval axis2_;
  Vector<Interval> unit_;  ///< b/b²
  Interval ring_radius_, factor_;
  bool is_disc_;
};

}  // namespace

SquaredDistance ring_distance(const scene::Component& component) { return Ring(component); }

}  // namespace isl::ISL_REFERENCE
