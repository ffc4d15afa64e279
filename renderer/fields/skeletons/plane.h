// The half-space behind a plane: q = (x/r)² with x = n·(p − a) before the plane, 0 behind it. It has no end across n,
// so it counts wherever the blob is looked at, inside its grid and out of it.
//
// Of an affine map M there remains a half-space: with n·M⁻¹p = |M⁻ᵀn| times the distance from the mapped plane, q is
// the same function of (distance/(r/|M⁻ᵀn|))². So maps are always baked in (component_table.cpp).
//
// Record: a place a on the plane, its unit normal b, radius_a.
#pragma once

#include "renderer/fields/skeletons/skeleton.h"

namespace isl::render {

struct HalfSpace {
  HalfSpace(const scene::Blob&, const scene::Component& c) : at(c.a), normal(c.b), radius(c.radius_a) {}

  Vec3 at;      ///< on the plane
  Vec3 normal;  ///< unit, out of the half-space
  double radius;

  [[nodiscard]] Foot nearest(const Vec3& p) const {
    return {normal * std::max((p - at).dot(normal), 0.0), 1 / (radius * radius)};
  }

  [[nodiscard]] QRange q_over(const Box& box) const {
    const PlaneRange x(box, at, normal);
    const double near = std::max(x.low / radius, 0.0), far = std::max(x.high / radius, 0.0);
    return {near * near, far * far};
  }

  [[nodiscard]] Coordinates coordinates(const Vec3& p, const scene::Turn&) const {
    return plane_coordinates(normal, p);
  }

  /// Where its field begins and ends, in its reach before the plane.
  static constexpr std::array<double, 2> kBorders = {0, 1};
  static constexpr bool kFillsBehind = true;  ///< the field is constant there, not gone

  [[nodiscard]] double thickest() const { return radius; }
  /// Without end but against the normal itself.
  [[nodiscard]] std::array<Reach, 2> reach(const Vec3& n) const {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const double along = n.dot(normal);
    const bool is_normal = along > 0 && (n - normal * along).length2() == 0;
    const Reach one{is_normal ? n.dot(at) : kInfinity, radius};
    return {one, one};
  }

  static constexpr std::size_t kMostPieces = 2;
  template <class Emit>
  void along(const Vec3& origin, const Vec3& direction, const Emit& emit) const {
    const double x = (origin - at).dot(normal), dx = direction.dot(normal);
    const double inverse_radius2 = 1 / (radius * radius);
    Breaks<1> breaks;
    breaks.add(x, dx, 0);
    breaks.for_each([&](double begin, double end, double inside) {
      if (x + inside * dx <= 0) return emit(QuadraticPiece{0, 0, 0, begin, end});
      // From where the ray meets the plane, to the bit: the hardest kernels are 10¹⁰⁰ times less a rounding beside it.
      if (dx != 0) return emit(QuadraticPiece{0, inverse_radius2 * dx * dx, (0 - x) / dx, begin, end});
      emit(QuadraticPiece{inverse_radius2 * x * x, 0, 0, begin, end});
    });
  }
};

}  // namespace isl::render
