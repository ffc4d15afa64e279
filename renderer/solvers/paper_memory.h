// The working memory of the published solver, one a thread: all interpolants on a ray at once.
#pragma once

#include "renderer/solvers/cubic.h"

#include <cstdint>
#include <vector>

namespace isl::render {

struct PaperMemory {
  /// One cubic Hermite interpolant of one field.
  struct Interpolant {
    double t0, value0, slope0, t1, value1, slope1;

    [[nodiscard]] CubicPoint at(double t) const {
      const double h = t1 - t0;
      const CubicPoint p = cubic_at(value0, value0 + h * slope0 / 3, value1 - h * slope1 / 3, value1, (t - t0) / h);
      return {p.value, p.slope / h};
    }
  };
  /// A cell that the ray crosses, and where it leaves it.
  struct VisitedCell {
    double t1;
    std::uint32_t index;
  };

  std::vector<Interpolant> interpolants, active;
  std::vector<VisitedCell> cells;
  std::vector<double> ends;

  void begin_ray(std::uint32_t components) {
    interpolants.clear();
    cells.clear();
    if (met_.size() < components || ray_ == 0xFFFFFFFFu) {
      met_.assign(components, 0);
      ray_ = 0;
    }
    ++ray_;
  }
  /// True the first time that this ray meets the component.
  [[nodiscard]] bool meet(std::uint32_t component) {
    if (met_[component] == ray_) return false;
    met_[component] = ray_;
    return true;
  }

 private:
  std::vector<std::uint32_t> met_;
  std::uint32_t ray_ = 0;
};

}  // namespace isl::render
