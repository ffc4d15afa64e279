// Outlines of random curves, for tests of the solids that are swept from them.
#pragma once

#include "tests/renderer/solids/solid_oracle.h"

#include <cstdint>
#include <vector>

namespace isl::render::test {

using scene::Outline;
using scene::PlanePoint;

/// A closed contour: control points, of which the first is repeated at the end, and the orders of its curves.
inline void add_contour(Outline& outline, const std::vector<PlanePoint>& points,
                        const std::vector<std::uint8_t>& orders) {
  outline.points.insert(outline.points.end(), points.begin(), points.end());
  outline.points.push_back(points.front());
  outline.orders.insert(outline.orders.end(), orders.begin(), orders.end());
  outline.contours.push_back(static_cast<std::uint32_t>(orders.size()));
}

/// One to three contours of two to six curves of any order, in the square from −1 to 1; they may cross themselves.
inline Outline random_outline(Random& random) {
  Outline outline;
  const auto point = [&] { return PlanePoint{random.uniform(-1, 1), random.uniform(-1, 1)}; };
  for (auto contours = static_cast<int>(random.uniform(1, 4)); contours > 0; --contours) {
    std::vector<PlanePoint> points;
    std::vector<std::uint8_t> orders;
    const auto curves = static_cast<int>(random.uniform(2, 7));
    for (int i = 0; i < curves; ++i) {
      orders.push_back(static_cast<std::uint8_t>(random.uniform(1, 4)));
      for (int k = 0; k < orders.back(); ++k) points.push_back(point());
    }
    add_contour(outline, points, orders);
  }
  outline.fills_by_winding = random.uniform(0, 1) < 0.5;
  return outline;
}

}  // namespace isl::render::test
