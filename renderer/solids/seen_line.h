// A line as it is seen in the plane of a sweep's outline, from the apex or along the axis (swept.h).
#pragma once

#include "renderer/solids/line_interval.h"
#include "renderer/solids/outline.h"
#include "renderer/solids/swept.h"

#include <cmath>
#include <utility>

namespace isl::render {

/// A point or a direction in the coordinates of a sweep.
struct SweptVector {
  PlanePoint section;
  double height;

  SweptVector(SweptAxes axes, const Vec3& v) : section{v[axes.u], v[axes.v]}, height(v[axes.height]) {}

  /// The point of the outline's plane over which it is.
  [[nodiscard]] PlanePoint seen(const scene::Outline& outline) const {
    return outline.is_conic ? PlanePoint{section.u / height, section.v / height} : section;
  }
};

[[nodiscard]] inline Vec3 in_space(SweptAxes axes, const PlanePoint& section, double height) {
  Vec3 result;
  result[axes.u] = section.u;
  result[axes.v] = section.v;
  result[axes.height] = height;
  return result;
}

/// A line as it is seen in the outline's plane.
class SeenLine {
 public:
  SeenLine(bool is_conic, const SweptVector& origin, const SweptVector& direction)
      : is_conic_(is_conic), origin_(origin), direction_(direction) {}

  /// Zero at the points of the plane that the line passes over.
  [[nodiscard]] LinearForm form() const {
    if (!is_conic_) return LinearForm::of_line(origin_.section, direction_.section);
    // The points (P, 1) in the plane through the line and the apex: det((P, 1), origin, direction) = 0.
    const auto [u, size_u] = minor(origin_.section.v, direction_.height, origin_.height, direction_.section.v);
    const auto [v, size_v] = minor(origin_.height, direction_.section.u, origin_.section.u, direction_.height);
    const auto [constant, size_constant] =
        minor(origin_.section.u, direction_.section.v, origin_.section.v, direction_.section.u);
    return {.u = u,
            .v = v,
            .constant = constant,
            .size_u = size_u,
            .size_v = size_v,
            .size_constant = size_constant,
            .base = {}};
  }

  /// t of the line's point over a point of the plane that it passes over.
  [[nodiscard]] double t_over(const PlanePoint& p) const {
    const PlanePoint& o = origin_.section;
    const PlanePoint& d = direction_.section;
    if (!is_conic_) return ((p.u - o.u) * d.u + (p.v - o.v) * d.v) / (d.u * d.u + d.v * d.v);
    // p (o.height + t d.height) = o + t d, by the coordinate that the line changes more.
    const double across_u = d.u - p.u * direction_.height, across_v = d.v - p.v * direction_.height;
    return std::abs(across_u) > std::abs(across_v) ? (p.u * origin_.height - o.u) / across_u
                                                   : (p.v * origin_.height - o.v) / across_v;
  }

  /// A rectangle of the plane that holds what the line passes over from t0 to t1.
  [[nodiscard]] PlaneWindow window(double t0, double t1) const {
    const double h0 = origin_.height + t0 * direction_.height, h1 = origin_.height + t1 * direction_.height;
    // A line through the height of the apex passes over points at infinity.
    if (!(t0 <= t1) || (is_conic_ && !(h0 * h1 > 0))) return {};
    const auto [low_u, high_u] = passed(origin_.section.u, direction_.section.u, t0, t1, h0, h1);
    const auto [low_v, high_v] = passed(origin_.section.v, direction_.section.v, t0, t1, h0, h1);
    return {{low_u, low_v}, {high_u, high_v}};
  }

  /// A t at which the line is outside: far away, or, of a conic sweep, where it passes the height of the apex.
  [[nodiscard]] double outside() const {
    return is_conic_ && direction_.height != 0 ? -origin_.height / direction_.height : -kInfinity;
  }

  /// True if the line passes over one point of the plane alone, which is `point`.
  [[nodiscard]] bool is_seen_as_point(const LinearForm& form, PlanePoint& point) const {
    if (form.u != 0 || form.v != 0 || form.constant != 0) return false;
    const double scale = is_conic_ ? 1 / direction_.height : 1;
    const PlanePoint& place = is_conic_ ? direction_.section : origin_.section;
    point = {place.u * scale, place.v * scale};
    return true;
  }

 private:
  /// The range of one coordinate, with room for the rounding of positions and of t itself, some ten units of the terms.
  [[nodiscard]] std::pair<double, double> passed(double o, double d, double t0, double t1, double h0, double h1) const {
    double a = d == 0 ? o : o + t0 * d, b = d == 0 ? o : o + t1 * d;
    double room = 0x1p-48 * (std::abs(o) + std::abs(a) + std::abs(b));
    if (is_conic_) {
      room = room / std::min(std::abs(h0), std::abs(h1)) *
             (1 + (std::abs(origin_.height) + std::abs(h0) + std::abs(h1)) / std::min(std::abs(h0), std::abs(h1)));
      a /= h0;
      b /= h1;
    }
    return {std::min(a, b) - room, std::max(a, b) + room};
  }

  static std::pair<double, double> minor(double a, double b, double c, double d) {
    return {a * b - c * d, std::abs(a * b) + std::abs(c * d)};
  }

  bool is_conic_;
  SweptVector origin_, direction_;
};

}  // namespace isl::render
