// A box with rounded edges: q = (squared distance to the box between two corners)/r². Inside the box q = 0, and the
// field has its greatest value throughout.
//
// The squared distance is Σ over the axes of (distance of the coordinate from the box's slab)². So between a ray's
// crossings of the box's six planes it is a quadratic, the sum over the axes on which the ray is outside the slab.
//
// Record: two corners, each coordinate of a below that of b; radius_a.
#pragma once

#include "renderer/fields/skeletons/skeleton.h"

namespace isl::render {

struct SolidBox {
  SolidBox(const scene::Blob&, const scene::Component& c) : low(c.a), high(c.b), radius(c.radius_a) {}

  Vec3 low, high;
  double radius;

  [[nodiscard]] Foot nearest(const Vec3& p) const {
    Vec3 offset;
    for (int i = 0; i < 3; ++i) offset[i] = p[i] - std::clamp(p[i], low[i], high[i]);
    return {offset, 1 / (radius * radius)};
  }

  [[nodiscard]] QRange q_over(const Box& box) const {
    QRange range{0, 0};
    for (int i = 0; i < 3; ++i) {
      const double nearest = std::max({low[i] - box.max[i], box.min[i] - high[i], 0.0});
      const double farthest = std::max({low[i] - box.min[i], box.max[i] - high[i], 0.0});
      range.low += nearest * nearest;
      range.high += farthest * farthest;
    }
    return {range.low / (radius * radius), range.high / (radius * radius)};
  }

  /// The coordinates of POV-Ray's box; around the rounded edges, those of the nearest point.
  [[nodiscard]] Coordinates coordinates(const Vec3& p, const scene::Turn&) const {
    return box_coordinates(low, high, p);
  }

  [[nodiscard]] Vec3 middle() const { return low + (high - low) * 0.5; }
  [[nodiscard]] double extent() const { return 0.5 * (high - low).length(); }
  [[nodiscard]] double thickest() const { return radius; }
  [[nodiscard]] std::array<Reach, 2> reach(const Vec3& n) const {
    double coordinate = 0;
    for (int i = 0; i < 3; ++i) coordinate += n[i] * (n[i] > 0 ? high[i] : low[i]);
    return {Reach{coordinate, radius}, Reach{coordinate, radius}};
  }

  static constexpr std::size_t kMostPieces = 7;
  template <class Emit>
  void along(const Vec3& origin, const Vec3& direction, const Emit& emit) const {
    Breaks<6> breaks;
    for (int i = 0; i < 3; ++i) {
      breaks.add(origin[i], direction[i], low[i]);
      breaks.add(origin[i], direction[i], high[i]);
    }
    const double inverse_radius2 = 1 / (radius * radius);
    breaks.for_each([&](double begin, double end, double inside) {
      // The offset of the ray's origin from the box's nearest point, and the ray's direction; both are 0 on the axes in
      // whose slab this piece lies.
      Vec3 from_box(0), by(0);
      for (int i = 0; i < 3; ++i) {
        const double x = origin[i] + inside * direction[i];
        if (x >= low[i] && x <= high[i]) continue;
        from_box[i] = origin[i] - (x < low[i] ? low[i] : high[i]);
        by[i] = direction[i];
      }
      emit(distance_piece(from_box, by, inverse_radius2, begin, end));
    });
  }
};

}  // namespace isl::render
