// The segment: q = (squared distance to the stretch from one point to another)/r², r the same all along. Along a
// ray, q is one quadratic between the planes at the ends, and the quadratic of the nearer end's sphere beyond them.
//
// Record: the ends a and b, radius_a.
#ifndef ISL_RENDERER_FIELDS_SKELETONS_SEGMENT_H_
#define ISL_RENDERER_FIELDS_SKELETONS_SEGMENT_H_

#include "renderer/fields/skeletons/skeleton.h"

namespace isl::render {

struct Segment {
  Segment(const scene::Blob&, const scene::Component& c) : a(c.a), length((c.b - c.a).length()), radius(c.radius_a) {
    axis = (c.b - c.a) / length;
  }

  Vec3 a;
  Vec3 axis;      ///< unit
  double length;  ///< > 0
  double radius;

  [[nodiscard]] Foot nearest(const Vec3& p) const {
    const Vec3 from_a = p - a;
    return {from_a - axis * std::clamp(from_a.dot(axis), 0.0, length), 1 / (radius * radius)};
  }

  /// Computed from the rectangle in (x, ρ), position along the axis and distance from it, that contains the box.
  [[nodiscard]] QRange q_over(const Box& box) const {
    const AxialRange range(box, a, axis);
    const double beyond_low = std::max({range.x_low - length, -range.x_high, 0.0});
    const double beyond_high = std::max({range.x_high - length, -range.x_low, 0.0});
    const double inverse_radius2 = 1 / (radius * radius);
    return {inverse_radius2 * (beyond_low * beyond_low + range.rho_low * range.rho_low),
            inverse_radius2 * (beyond_high * beyond_high + range.rho_high * range.rho_high)};
  }

  /// First coordinate: position along the axis, 0 at a and 1 at b, constant on the caps. Second: share of a turn around
  /// the axis, from AcrossAxis' x.
  [[nodiscard]] Coordinates coordinates(const Vec3& p, const scene::Turn& turn) const {
    const Vec3 from_a = p - a;
    const AcrossAxis across(turn.back(axis));
    return {std::clamp(from_a.dot(axis) / length, 0.0, 1.0), across.share_of_turn(turn.back(from_a))};
  }

  [[nodiscard]] Vec3 middle() const { return a + axis * (0.5 * length); }
  [[nodiscard]] double extent() const { return 0.5 * length; }
  [[nodiscard]] double thickest() const { return radius; }
  [[nodiscard]] std::array<Reach, 2> reach(const Vec3& n) const {
    const double at_a = n.dot(a);
    return {Reach{at_a, radius}, Reach{at_a + n.dot(axis) * length, radius}};
  }

  static constexpr std::size_t kMostPieces = 3;
  template <class Emit>
  void along(const Vec3& origin, const Vec3& direction, const Emit& emit) const {
    const Vec3 from_a = origin - a;
    const double x = from_a.dot(axis), dx = direction.dot(axis);
    const double inverse_radius2 = 1 / (radius * radius);
    Breaks<2> breaks;
    breaks.add(x, dx, 0);
    breaks.add(x, dx, length);
    breaks.for_each([&](double begin, double end, double inside) {
      const double place = x + inside * dx;
      if (place < 0) return emit(sphere_piece(a, inverse_radius2, origin, direction, begin, end));
      if (place > length) return emit(sphere_piece(a + axis * length, inverse_radius2, origin, direction, begin, end));
      emit(distance_piece(from_a - axis * x, direction - axis * dx, inverse_radius2, begin, end));
    });
  }
};

}  // namespace isl::render

#endif  // ISL_RENDERER_FIELDS_SKELETONS_SEGMENT_H_

// The pieces along eight rays: those of the sphere at a, of the tube between the ends, and of the sphere at b.
#ifdef ISL_RAY_FORMS  // renderer/fields/skeletons/ray_forms-inl.h
HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct SegmentPieces {
  template <class Emit>
  static HWY_INLINE void along(const Segment& segment, const Lines<Octet>& lines, const Emit& emit) {
    const Octet zero(0.0), length(segment.length), inverse_radius2(1 / (segment.radius * segment.radius));
    const Octet infinity(std::numeric_limits<double>::infinity());
    const AboutAxis<Octet> line = about_axis(segment.a, segment.axis, lines);
    const Octet inverse_dx = Octet(1.0) / line.dx;
    // A ray across the axis is beside one piece all along. If the inverse overflows, it moves along the axis by less
    // than a rounding.
    const OctetMask across = abs(inverse_dx) >= infinity, forward = line.dx > zero;
    const Octet at_a = (zero - line.x0) * inverse_dx, at_b = (length - line.x0) * inverse_dx;
    const auto piece = [&](const Octet& begin, const Octet& end, const OctetMask& all, const auto& quadratic) HWY_ATTR {
      emit(select(across, select(all, zero - infinity, infinity), begin),
           select(across, select(all, infinity, zero - infinity), end), quadratic);
    };
    piece(select(forward, zero - infinity, at_a), select(forward, at_a, infinity), line.x0 < zero,
          [&]() HWY_ATTR { return sphere_quadratic(segment.a, inverse_radius2, lines); });
    piece(min(at_a, at_b), max(at_a, at_b), (line.x0 >= zero) & (line.x0 <= length), [&]() HWY_ATTR {
      return OctetQuadratic{inverse_radius2 * line.n0, inverse_radius2 * line.n2, line.middle};
    });
    piece(select(forward, at_b, zero - infinity), select(forward, infinity, at_b), line.x0 > length, [&]() HWY_ATTR {
      return sphere_quadratic(segment.a + segment.axis * segment.length, inverse_radius2, lines);
    });
  }
};

template <>
struct PiecesAlong<Segment> {
  using type = SegmentPieces;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();
#endif
