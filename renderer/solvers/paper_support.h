// Where a component's field begins and ends on a ray, for the published solver: on most skeletons one interval, the sets
// v ≤ c being convex.
#pragma once

#include "renderer/solvers/paper_line.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isl::render {

/// Where v < support: from its first to its last point on the line.
[[nodiscard]] inline bool support_on(const FieldLine& line, double& begin, double& end) {
  const double support = line.group.kernel.support, dd = line.direction.length2();
  if (line.group.skeleton == scene::Skeleton::point) {
    const ComponentTable& table = line.table;
    const Vec3 centre(table.x[line.item], table.y[line.item], table.z[line.item]);
    const double scale = table.scale[line.item];
    const QuadraticPiece v = sphere_piece(centre, scale, line.origin, line.direction, 0, 0);
    if (!(v.q0 < support)) return false;
    const double half = std::sqrt((support - v.q0) / v.kappa);
    begin = v.middle - half;
    end = v.middle + half;
    return half > 0;
  }
  // The line beyond these two is out of reach.
  const double root_q = ComponentTable::support_root(line.group), start = line.origin.dot(line.direction);
  const auto farthest = [&](const Vec3& n) {
    const std::array<Reach, 2> reach =
        line.table.with_skeleton(line.group, line.item, [&](const auto& skeleton) { return skeleton.reach(n); });
    const double spread = root_q * std::sqrt(dd);
    return std::max(reach[0].coordinate + reach[0].radius * spread, reach[1].coordinate + reach[1].radius * spread);
  };
  const double low = (-farthest(-line.direction) - start) / dd, high = (farthest(line.direction) - start) / dd;
  double first = 0, last = 0;  // points in the support
  if (line.group.skeleton == scene::Skeleton::circle) {
    // A line can leave a torus and come back; a stretch thinner than these steps goes unseen, as the mode allows.
    constexpr int kSteps = 256;
    bool is_met = false;
    for (int i = 1; i < kSteps; ++i) {
      const double t = low + (high - low) * i / kSteps;
      if (!(line.at(t).v < support)) continue;
      if (!is_met) first = t;
      last = t;
      is_met = true;
    }
    if (!is_met) return false;
  } else {
    double before = low, behind = high;
    for (int i = 0; i < 60; ++i) {  // v is quasi-convex along the ray: its slope changes sign once
      const double middle = 0.5 * (before + behind);
      (line.at(middle).slope > 0 ? behind : before) = middle;
    }
    first = last = 0.5 * (before + behind);
    if (!(line.at(first).v < support)) return false;
  }
  const auto border = [&](double inner, double outer) {
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (inner + outer);
      (line.at(middle).v < support ? inner : outer) = middle;
    }
    return inner;
  };
  begin = border(first, low);
  end = border(last, high);
  return end > begin;
}

}  // namespace isl::render
