// The half-space behind a plane: q = (x/r)² with x = n·(p − a) before the plane, 0 behind it. It is unbounded
// across n, so its field is evaluated everywhere, inside the blob's grid and outside.
//
// An affine map M takes the half-space to a half-space: n·M⁻¹p is |M⁻ᵀn| times the distance from the mapped plane, so q
// is (distance/(r/|M⁻ᵀn|))², that of a half-space with the radius r/|M⁻ᵀn|. So maps are always baked in
// (component_table.cpp).
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

  /// The x at which the field changes its form, in units of the field's reach before the plane: up to the first it is
  /// constant, from the last on it is 0.
  static constexpr std::array<double, 2> kBorders = {0, 1};
  static constexpr bool kFillsBehind = true;  ///< the field behind the first border is constant, not 0

  [[nodiscard]] const Vec3& middle() const { return at; }
  [[nodiscard]] double extent() const { return 0; }
  [[nodiscard]] double thickest() const { return radius; }
  /// Infinite, except along the normal itself.
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
      // The quadratic is centred on the ray's crossing of the plane, so that q is exactly 0 there: the hardest kernels
      // are 10¹⁰⁰ times smaller one rounding away.
      if (dx != 0) return emit(QuadraticPiece{0, inverse_radius2 * dx * dx, (0 - x) / dx, begin, end});
      emit(QuadraticPiece{inverse_radius2 * x * x, 0, 0, begin, end});
    });
  }
};

}  // namespace isl::render
