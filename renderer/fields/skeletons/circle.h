// The circle (a torus): q = ((ρ − R)² + z²)/r², with z along the axis from the circle's centre and ρ from the axis. On
// the axis the distance has a crease, so the support must not reach it (the interpreter sees to that): R > r √Q. Along
// a ray q is no polynomial; circle_lanes-inl.h has its lanes.
#pragma once

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

  /// As POV-Ray's torus has them, which lies across y.
  [[nodiscard]] Coordinates coordinates(const Vec3& p, const scene::Turn&) const {
    const Vec3 from_centre = p - centre;
    const AcrossAxis across(axis);
    return torus_coordinates({from_centre.dot(across.x), from_centre.dot(axis), from_centre.dot(across.z)}, ring_radius);
  }

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
