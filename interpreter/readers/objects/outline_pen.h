// Draws the contours of an outline, curve by curve, as fonts and splines describe them.
#pragma once

#include "renderer/scene/solids.h"

#include <algorithm>
#include <initializer_list>

namespace isl::interpreter {

using scene::PlanePoint;

/// Curves without length are left out, and so are contours without curves.
class OutlinePen {
 public:
  explicit OutlinePen(scene::Outline& outline) : outline_(outline) {}

  /// Begins a contour.
  void move_to(const PlanePoint& begin) {
    close();
    first_ = outline_.points.size();
    outline_.points.push_back(begin);
  }

  /// A Bézier curve from the present end: one to three control points, of which the last is the new end.
  void curve_to(std::initializer_list<PlanePoint> points) {
    const PlanePoint& end = outline_.points.back();
    if (std::ranges::all_of(points, [&](const PlanePoint& p) { return p == end; })) return;
    outline_.points.insert(outline_.points.end(), points);
    outline_.orders.push_back(static_cast<std::uint8_t>(points.size()));
    ++curves_;
  }

  [[nodiscard]] const PlanePoint& begin() const { return outline_.points[first_]; }
  [[nodiscard]] const PlanePoint& end() const { return outline_.points.back(); }

  /// Ends the contour, with a line to its beginning if it is not there.
  void close() {
    if (first_ == outline_.points.size()) return;
    const PlanePoint first = begin();
    curve_to({first});
    if (curves_ == 0) {
      outline_.points.resize(first_);
    } else {
      outline_.contours.push_back(curves_);
    }
    curves_ = 0;
    first_ = outline_.points.size();
  }

  /// Takes back what was drawn of the contour.
  void discard() {
    outline_.points.resize(first_);
    outline_.orders.resize(outline_.orders.size() - curves_);
    curves_ = 0;
  }

 private:
  scene::Outline& outline_;
  std::size_t first_ = outline_.points.size();  ///< the first point of the contour
  std::uint32_t curves_ = 0;                    ///< of the contour, so far
};

}  // namespace isl::interpreter
