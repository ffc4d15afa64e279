// The point: q = |p − c|²/r². Most components are points, so they are stored in columns of the table, from which
// lane_setup-inl.h reads eight components at once.
//
// Record: the position a, radius_a.
#ifndef ISL_RENDERER_FIELDS_SKELETONS_POINT_H_
#define ISL_RENDERER_FIELDS_SKELETONS_POINT_H_

#include "renderer/fields/skeletons/skeleton.h"

namespace isl::render {

struct Point {
  Point(const Vec3& centre_, double inverse_radius2_) : centre(centre_), inverse_radius2(inverse_radius2_) {}
  Point(const scene::Blob&, const scene::Component& c) : Point(c.a, 1 / (c.radius_a * c.radius_a)) {}

  Vec3 centre;
  double inverse_radius2;

  [[nodiscard]] Foot nearest(const Vec3& p) const { return {p - centre, inverse_radius2}; }

  [[nodiscard]] QRange q_over(const Box& box) const {
    QRange range{0, 0};
    for (int axis = 0; axis < 3; ++axis) {
      const double below = box.min[axis] - centre[axis], above = centre[axis] - box.max[axis];
      const double nearest = std::max({below, above, 0.0});
      const double farthest = std::max(-below, -above);
      range.low += nearest * nearest;
      range.high += farthest * farthest;
    }
    return {range.low * inverse_radius2, range.high * inverse_radius2};
  }

  [[nodiscard]] Coordinates coordinates(const Vec3& p, const scene::Turn& turn) const {
    return sphere_coordinates(turn.back(p - centre));
  }

  [[nodiscard]] const Vec3& middle() const { return centre; }
  [[nodiscard]] double extent() const { return 0; }
  [[nodiscard]] double thickest() const { return 1 / std::sqrt(inverse_radius2); }
  [[nodiscard]] std::array<Reach, 2> reach(const Vec3& n) const {
    const Reach centre_only{n.dot(centre), thickest()};
    return {centre_only, centre_only};
  }

  static constexpr std::size_t kMostPieces = 1;
  template <class Emit>
  void along(const Vec3& origin, const Vec3& direction, const Emit& emit) const {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    emit(sphere_piece(centre, inverse_radius2, origin, direction, -kInfinity, kInfinity));
  }
};

}  // namespace isl::render

#endif  // ISL_RENDERER_FIELDS_SKELETONS_POINT_H_

// The piece along eight rays of a point that is mapped.
#ifdef ISL_RAY_FORMS  // renderer/fields/skeletons/ray_forms-inl.h
HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct PointPieces {
  template <class Emit>
  static HWY_INLINE void along(const Point& point, const Lines<Octet>& lines, const Emit& emit) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    emit(Octet(-kInfinity), Octet(kInfinity),
         [&]() HWY_ATTR { return sphere_quadratic(point.centre, Octet(point.inverse_radius2), lines); });
  }
};

template <>
struct PiecesAlong<Point> {
  using type = PointPieces;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();
#endif
