// Points at random on area lights with `jitter`. POV-Ray moves each point of the grid by up to half of the way to the
// next, anew for every ray. The light that arrives on average is that of a continuous density, which is constant in a
// cell around each point of the grid and has the point's weight there; these are points of that density.
#pragma once

#include "renderer/numerics/sample_points.h"
#include "renderer/shading/area_grid.h"

#include <cstddef>
#include <vector>

namespace isl::render {

class AreaPoints {
 public:
  explicit AreaPoints(const scene::AreaLight& area) : area_(area), row_a_(area.count_a), row_b_(area.count_b) {}

  /// The place, relative to the light's centre, that belongs to a point of the unit square. Equal areas of the square
  /// have equal weights.
  [[nodiscard]] Vec3 offset(const AreaEdges& edges, const UnitPoint& at) const {
    return area_offset(area_, edges, row_a_.place(at.u), row_b_.place(at.v));
  }
  /// The same where all points of the grid weigh the same.
  [[nodiscard]] Vec3 even_offset(const AreaEdges& edges, const UnitPoint& at) const {
    return area_offset(area_, edges, at.u * area_.count_a - 0.5, at.v * area_.count_b - 0.5);
  }
  [[nodiscard]] int count() const { return area_.count_a * area_.count_b; }

 private:
  /// A row of points, which are at whole numbers, with the cell around each.
  class Row {
   public:
    explicit Row(int count) {
      double begin = 0;
      for (const double weight : area_weights(count)) {
        begins_.push_back(begin);
        per_share_.push_back(1 / weight);
        begin += weight;
      }
    }
    /// The place of a share of the row's weight.
    [[nodiscard]] double place(double share) const {
      // The steps of a search would be as good as random, which is slower than to ask all cells of a row.
      std::size_t begun = 0;
      for (const double begin : begins_) begun += begin <= share ? 1 : 0;
      return static_cast<double>(begun) - 1.5 + (share - begins_[begun - 1]) * per_share_[begun - 1];
    }

   private:
    std::vector<double> begins_;     ///< sums of the weights before each cell
    std::vector<double> per_share_;  ///< how far a share of the weight leads in a cell
  };

  scene::AreaLight area_;
  Row row_a_, row_b_;
};

}  // namespace isl::render
