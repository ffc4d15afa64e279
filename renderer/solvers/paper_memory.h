// The working memory of the published solver, one a thread: all interpolants on a ray at once.
#pragma once

#include "renderer/solvers/cubic.h"

#include <cstdint>
#include <vector>

namespace isl::render {

/// Value and slope at both ends of a stretch.
struct HermiteSum {
  double value0 = 0, slope0 = 0, value1 = 0, slope1 = 0;

  HermiteSum& operator+=(const HermiteSum& other) {
    value0 += other.value0;
    slope0 += other.slope0;
    value1 += other.value1;
    slope1 += other.slope1;
    return *this;
  }
};

struct PaperMemory {
  /// One cubic Hermite interpolant of one field.
  struct Interpolant {
    double t0, value0, slope0, t1, value1, slope1;
    std::uint32_t branch;  ///< that the field is in

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
  std::vector<HermiteSum> branch_sums, sums;  ///< of one stretch: by branch; by selection, less the threshold

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
