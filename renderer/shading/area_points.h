// Points at random on area lights with `jitter`. POV-Ray moves each point of the grid by up to half of the way to the
// next, anew for every ray. The light that arrives on average is that of a continuous density, which is constant in a
// cell around each point of the grid and has the point's weight there; these are points of that density.
#pragma once

#include "renderer/numerics/sample_points.h"
#include "renderer/shading/area_grid.h"

#include <vector>

namespace isl::render {

class AreaPoints {
 public:
  explicit AreaPoints(const scene::AreaLight& area)
      : area_(area), ends_a_(ends(area.count_a)), ends_b_(ends(area.count_b)) {}

  /// The place, relative to the light's centre, that belongs to a point of the unit square. Equal areas of the square
  /// have equal weights.
  [[nodiscard]] Vec3 offset(const AreaEdges& edges, const UnitPoint& at) const {
    return area_offset(area_, edges, along(ends_a_, at.u), along(ends_b_, at.v));
  }
  /// The same where all points of the grid weigh the same.
  [[nodiscard]] Vec3 even_offset(const AreaEdges& edges, const UnitPoint& at) const {
    return area_offset(area_, edges, at.u * area_.count_a - 0.5, at.v * area_.count_b - 0.5);
  }
  [[nodiscard]] int count() const { return area_.count_a * area_.count_b; }

 private:
  /// Sums of the weights of the points of a row, up to and with each.
  static std::vector<double> ends(int count) {
    std::vector<double> sums = area_weights(count);
    for (std::size_t i = 1; i < sums.size(); ++i) sums[i] += sums[i - 1];
    sums.back() = 1;  // above every coordinate
    return sums;
  }
  /// The place in a row of points, which are at whole numbers.
  [[nodiscard]] static double along(const std::vector<double>& ends, double share) {
    const auto end = std::ranges::upper_bound(ends, share);
    const double begin = end == ends.begin() ? 0 : *std::prev(end);
    return static_cast<double>(end - ends.begin()) - 0.5 + (share - begin) / (*end - begin);
  }

  scene::AreaLight area_;
  std::vector<double> ends_a_, ends_b_;
};

}  // namespace isl::render
