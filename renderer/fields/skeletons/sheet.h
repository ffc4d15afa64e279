// The plane as a sheet without thickness: q = (x/r)² with x = n·(p − a), on both sides. What a convolved plane is a
// function of (convolutions/sheet_*). It has no end across n, so it counts wherever the blob is looked at, inside its
// grid and out of it.
//
// Affine maps leave a sheet, and are baked in, for the reason that plane.h gives.
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

  /// Where its field begins, is greatest and ends, in its reach before the plane. The middle matters to the hardest,
  /// which have a spike there.
  static constexpr std::array<double, 3> kBorders = {-1, 0, 1};
  static constexpr bool kFillsBehind = false;  ///< behind the last border its field is gone

  [[nodiscard]] double thickest() const { return radius; }
  /// Without end but along the normal itself.
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
    // From where the ray meets the plane, to the bit, as of a half-space; unless that is farther than any scene
    // reaches.
    const double middle = (0 - x) / dx;
    if (std::abs(middle) < 1e150)
      return emit(QuadraticPiece{0, inverse_radius2 * dx * dx, middle, -kInfinity, kInfinity});
    emit(QuadraticPiece{inverse_radius2 * x * x, 0, 0, -kInfinity, kInfinity});
  }
};

}  // namespace isl::render
