// The plane as a sheet without thickness: q = (x/r)² with x = n·(p − a), on both sides. The field of a convolved plane
// is a function of this q (kernels/sheet_cauchy-inl.h, cubic-inl.h). The sheet is unbounded across n, so its field is
// evaluated everywhere, inside the blob's grid and outside.
//
// An affine map takes a sheet to a sheet, and is baked in, as plane.h derives.
//
// Record: a place a on the plane, its unit normal b, radius_a.
#pragma once

#include "renderer/fields/skeletons/skeleton.h"

namespace isl::render {

struct Sheet {
  Sheet(const scene::Blob&, const scene::Component& c) : at(c.a), normal(c.b), radius(c.radius_a) {}

  Vec3 at;      ///< on the plane
  Vec3 normal;  ///< unit
  double radius;

  [[nodiscard]] Foot nearest(const Vec3& p) const { return {normal * (p - at).dot(normal), 1 / (radius * radius)}; }

  [[nodiscard]] QRange q_over(const Box& box) const {
    const PlaneRange x(box, at, normal);
    const double near = std::max({x.low, -x.high, 0.0}) / radius, far = std::max(x.high, -x.low) / radius;
    return {near * near, far * far};
  }

  [[nodiscard]] Coordinates coordinates(const Vec3& p, const scene::Turn&) const {
    return plane_coordinates(normal, p);
  }

  /// The x at which the field begins, is greatest and ends, in units of the field's reach. The middle is needed for the
  /// hardest kernels, which have a spike there.
  static constexpr std::array<double, 3> kBorders = {-1, 0, 1};
  static constexpr bool kFillsBehind = false;  ///< the field is 0 on both sides beyond the borders

  [[nodiscard]] const Vec3& middle() const { return at; }
  [[nodiscard]] double extent() const { return 0; }
  [[nodiscard]] double thickest() const { return radius; }
  /// Infinite, except along the normal itself and against it.
  [[nodiscard]] std::array<Reach, 2> reach(const Vec3& n) const {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const bool is_normal = (n - normal * n.dot(normal)).length2() == 0;
    const Reach one{is_normal ? n.dot(at) : kInfinity, radius};
    return {one, one};
  }

  static constexpr std::size_t kMostPieces = 1;
  template <class Emit>
  void along(const Vec3& origin, const Vec3& direction, const Emit& emit) const {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const double x = (origin - at).dot(normal), dx = direction.dot(normal);
    const double inverse_radius2 = 1 / (radius * radius);
    // The quadratic is centred on the ray's crossing of the plane, as in plane.h, unless that is farther away than any
    // scene reaches.
    const double middle = (0 - x) / dx;
    if (std::abs(middle) < 1e150)
      return emit(QuadraticPiece{0, inverse_radius2 * dx * dx, middle, -kInfinity, kInfinity});
    emit(QuadraticPiece{inverse_radius2 * x * x, 0, 0, -kInfinity, kInfinity});
  }
};

}  // namespace isl::render
