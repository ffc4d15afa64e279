#include "renderer/solids/outline_map.h"

#include "renderer/solids/outline.h"
#include "renderer/solids/plane_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace isl::render {
namespace {

/// With 64 cells for each curve, the inside of a letter's stroke has cells that no curve crosses. The limit keeps the
/// map of a long text small.
constexpr double kCellsPerCurve = 64, kMostMapCells = 65536;

struct PlaneBox {
  PlanePoint low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};

  void add(const PlanePoint& p) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
};

/// Marks the cells that hold parts of curves.
class CurveMarker {
 public:
  explicit CurveMarker(OutlineMap& map) : map_(map) {}

  /// Halves the curve until the box of its control points is about as small as a cell. `halvings` is the most.
  void mark(Curve curve, int halvings) {
    PlaneBox box;
    for (const PlanePoint& p : curve) box.add(p);
    // Halves are off by some roundings of their control points.
    const double room =
        0x1p-46 * std::max({std::abs(box.low.u), std::abs(box.high.u), std::abs(box.low.v), std::abs(box.high.v)});
    const int u0 = std::max(map_.column(box.low.u - room), 0),
              u1 = std::min(map_.column(box.high.u + room), map_.columns - 1);
    const int v0 = std::max(map_.row(box.low.v - room), 0), v1 = std::min(map_.row(box.high.v + room), map_.rows - 1);
    if (halvings > 0 && u1 > u0 && v1 > v0) {
      std::array<PlanePoint, kMostPoints> below, above;
      const std::size_t points = curve.size();
      std::ranges::copy(curve, above.begin());
      for (std::size_t i = 0; i < points; ++i) {
        below[i] = above[0];
        for (std::size_t k = 0; k + i + 1 < points; ++k) above[k] = above[k] * 0.5 + above[k + 1] * 0.5;
      }
      // De Casteljau's scheme leaves the last point of each level where it is. These are the points of the upper half.
      mark(std::span(below).first(points), halvings - 1);
      mark(std::span(above).first(points), halvings - 1);
      return;
    }
    for (int v = v0; v <= v1; ++v) {
      for (int u = u0; u <= u1; ++u) map_.at(u, v) = OutlineMap::Side::mixed;
    }
  }

 private:
  OutlineMap& map_;
};

/// Tells inside from outside in the cells of a row that no curve comes near, along the line through their middles.
void set_sides_of_row(const PreparedOutline& outline, int row, std::vector<OutlineCrossing>& crossings,
                      OutlineMap& map) {
  const double v = map.low.v + (row + 0.5) / map.per_unit.v;
  crossings.clear();
  find_crossings(outline, LinearForm::of_line({map.low.u, v}, {1, 0}), crossings);
  std::ranges::sort(crossings, {}, [](const OutlineCrossing& crossing) { return crossing.point.u; });
  OutlineFill fill(outline.outline);
  std::size_t passed = 0;
  for (int column = 0; column < map.columns; ++column) {
    OutlineMap::Side& side = map.at(column, row);
    const double u = map.low.u + (column + 0.5) / map.per_unit.u;
    for (; passed < crossings.size() && crossings[passed].point.u < u; ++passed) fill.pass(crossings[passed]);
    if (side != OutlineMap::Side::mixed) side = fill.is_inside() ? OutlineMap::Side::inside : OutlineMap::Side::outside;
  }
}

}  // namespace

OutlineMap map_of(const PreparedOutline& outline) {
  OutlineMap map;
  PlaneBox box;
  for (const OutlineNode& node : outline.nodes) {
    box.add(node.low);
    box.add(node.high);
  }
  const double width = box.high.u - box.low.u, height = box.high.v - box.low.v;
  const double size = std::max({std::abs(box.low.u), std::abs(box.high.u), std::abs(box.low.v), std::abs(box.high.v)});
  // Without an extent, or one far below its coordinates, cells are smaller than roundings.
  if (!(width > 0x1p-20 * size && height > 0x1p-20 * size)) return map;
  const double cells = std::min(kCellsPerCurve * static_cast<double>(outline.outline.orders.size()), kMostMapCells);
  const auto along = [&](double side, double other) {
    return static_cast<int>(std::ceil(std::clamp(std::sqrt(cells * side / other), 1.0, cells)));
  };
  map.columns = along(width, height);
  map.rows = along(height, width);
  map.low = box.low;
  // A little less, so that the box's far sides are within the last cells.
  constexpr double kWithin = 1 - 0x1p-20;
  map.per_unit = {kWithin * map.columns / width, kWithin * map.rows / height};
  map.sides.assign(static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows),
                   OutlineMap::Side::outside);
  CurveMarker marker(map);
  for (const OutlineNode& node : outline.nodes) {
    if (node.order > 0) marker.mark(curve_of(outline.outline, node), 6);
  }
  std::vector<OutlineCrossing> crossings;
  for (int row = 0; row < map.rows; ++row) set_sides_of_row(outline, row, crossings, map);
  return map;
}

}  // namespace isl::render
