// The inner loops' view of one component along a ray (renderer/fields/ray/ray_lanes-inl.h), compiled once for all tests
// that look at it, because it takes as long to compile as a hundred other test files. Compiled for the baseline SIMD
// target; tests/renderer/trace/simd_targets_test.cpp shows that all vector widths give the same bits.
#pragma once

#include "renderer/fields/branches.h"
#include "renderer/fields/component_table.h"

#include <memory>

namespace isl::test {

/// F − T and dF/dt at a place of the ray.
struct RayValue {
  double value, slope;
  double steepness;  ///< Σ|fᵢ′|
  double noise;      ///< bound of the rounding error in `value`
};

/// Bounds of the distance of a cubic Hermite interpolant from F, and of its derivative from F′.
struct RayRemainder {
  double value, slope;
};

/// The table's first component along origin + t·direction for t in [t0, t1]; all queries must lie in that interval.
class RayFields {
 public:
  RayFields(const render::ComponentTable& table, const scene::Vec3& origin, const scene::Vec3& direction, double t0,
            double t1);
  ~RayFields();

  [[nodiscard]] RayValue at(double t) const;
  /// Enclosures of F − T, F′ and F″ on [a, b].
  [[nodiscard]] render::FieldRange range(double a, double b) const;
  [[nodiscard]] render::FieldRange slope_range(double a, double b) const;
  [[nodiscard]] render::FieldRange bend_range(double a, double b) const;
  /// Remainder bounds of the interpolant with nodes a and b.
  [[nodiscard]] RayRemainder remainder(double a, double b) const;

 private:
  struct Lanes;
  std::unique_ptr<const Lanes> lanes_;
};

}  // namespace isl::test
