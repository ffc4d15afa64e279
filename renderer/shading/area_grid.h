// The points of area lights, as in POV-Ray: a grid of u times v points spanned by two edges about the light's centre,
// or pressed into an ellipse (`circular`), or turned to the lit point (`orient`).
#pragma once

#include "renderer/scene/light.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace isl::render {

using scene::Vec3;

/// The edges of an area light as a lit point sees them.
struct AreaEdges {
  Vec3 a{0}, b{0};
};

/// `to_light` is the unit direction from the lit point to the light's centre.
[[nodiscard]] inline AreaEdges edges_of(const scene::AreaLight& area, const Vec3& to_light) {
  if (!area.orient) return {area.edge_a, area.edge_b};
  // The edges of a light that is turned to the point are perpendicular to the way, the first of them to z as well, or
  // to y where the way is almost along z.
  constexpr double kAlmostZ = 0.01;
  const bool is_almost_z = std::abs(std::abs(to_light.z) - 1) < kAlmostZ;
  const Vec3 a = to_light.cross(is_almost_z ? Vec3(0, 1, 0) : Vec3(0, 0, 1)).normalized();
  const double length = area.edge_a.length();
  return {a * length, to_light.cross(a).normalized() * length};
}

/// The point (u, v) of the grid, relative to the light's centre; u and v count from 0, and may lie between points or
/// beside them.
[[nodiscard]] inline Vec3 area_offset(const scene::AreaLight& area, const AreaEdges& edges, double u, double v) {
  const auto across = [](double i, int count) { return count > 1 ? i / (count - 1) - 0.5 : 0; };
  double a = across(u, area.count_a), b = across(v, area.count_b);
  if (area.circular) {
    // POV-Ray moves the points of such a light by a thousandth of its edges, so that none is in the middle, where the
    // map to the disc has no direction.
    constexpr double kBesideTheMiddle = 0.001;
    a += kBesideTheMiddle;
    b += kBesideTheMiddle;
    const auto [shorter, longer] = std::minmax({std::abs(a), std::abs(b)});
    const double slope = shorter / longer;
    const double scale = 1 / std::sqrt(1 + slope * slope);
    a *= scale;
    b *= scale;
  }
  return edges.a * a + edges.b * b;
}

/// A rectangle of the grid, its last points included. The light that arrives from it is estimated by the mean of its
/// corners, or of its quarters if it is divided.
struct AreaPart {
  int u1 = 0, v1 = 0, u2 = 0, v2 = 0;

  [[nodiscard]] static AreaPart whole(const scene::AreaLight& area) {
    return {0, 0, area.count_a - 1, area.count_b - 1};
  }
  /// True if it has points beside its corners.
  [[nodiscard]] bool can_be_divided() const { return u2 - u1 > 1 || v2 - v1 > 1; }
  /// One of four: bit 0 of `which` tells the half of u, bit 1 that of v. Where no point is in the middle of a side, the
  /// quarters have none in common.
  [[nodiscard]] AreaPart quarter(unsigned which) const {
    AreaPart part = *this;
    ((which & 1U) != 0 ? part.u1 : part.u2) = (u1 + u2 + static_cast<int>(which & 1U)) / 2;
    ((which & 2U) != 0 ? part.v1 : part.v2) = (v1 + v2 + static_cast<int>(which >> 1U)) / 2;
    return part;
  }
};

/// The weights of `count` points in a row, or a column, where all points are sampled: those of a whole grid are their
/// products, because a part is divided along both sides at once, and dividing a side that has no point within it does
/// not change the mean of its ends.
[[nodiscard]] inline std::vector<double> area_weights(int count) {
  std::vector<double> weights(static_cast<std::size_t>(count));
  struct Side {
    int first, last;
    double weight;
  };
  std::vector<Side> pending{{0, count - 1, 1}};
  while (!pending.empty()) {
    const Side side = pending.back();
    pending.pop_back();
    if (side.last - side.first > 1) {
      pending.push_back({side.first, (side.first + side.last) / 2, side.weight / 2});
      pending.push_back({(side.first + side.last + 1) / 2, side.last, side.weight / 2});
      continue;
    }
    weights[static_cast<std::size_t>(side.first)] += side.weight / 2;
    weights[static_cast<std::size_t>(side.last)] += side.weight / 2;
  }
  return weights;
}

}  // namespace isl::render
