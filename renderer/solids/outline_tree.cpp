// The tree of an outline's curves, and what is found without a line: the nearest place on a curve, and the reach.
#include "renderer/solids/outline.h"
#include "renderer/solids/plane_curve.h"

#include <limits>

namespace isl::render {

using scene::Outline;

std::span<const PlanePoint> curve_of(const Outline& outline, const OutlineNode& node) {
  return std::span(outline.points).subspan(node.first, static_cast<std::size_t>(node.order) + 1);
}

namespace {

/// Appends the nodes of the curves from `begin` to `end`. `points` holds the first control point of each.
std::uint32_t add_nodes(PreparedOutline& result, std::span<const std::uint32_t> points, std::size_t begin,
                        std::size_t end) {
  const Outline& outline = result.outline;
  const auto own = static_cast<std::uint32_t>(result.nodes.size());
  OutlineNode node;
  result.nodes.push_back(node);
  if (end - begin == 1) {
    node.first = points[begin];
    node.order = outline.orders[begin];
    const Curve curve = curve_of(outline, node);
    node.low = node.high = curve[0];
    for (const PlanePoint& p : curve) {
      node.low = {std::min(node.low.u, p.u), std::min(node.low.v, p.v)};
      node.high = {std::max(node.high.u, p.u), std::max(node.high.v, p.v)};
    }
  } else {
    const std::size_t middle = begin + (end - begin) / 2;
    const OutlineNode& left = result.nodes[add_nodes(result, points, begin, middle)];
    node.low = left.low;
    node.high = left.high;
    const OutlineNode& right = result.nodes[add_nodes(result, points, middle, end)];
    node.low = {std::min(node.low.u, right.low.u), std::min(node.low.v, right.low.v)};
    node.high = {std::max(node.high.u, right.high.u), std::max(node.high.v, right.high.v)};
  }
  node.next = static_cast<std::uint32_t>(result.nodes.size());
  result.nodes[own] = node;
  return own;
}

}  // namespace

PreparedOutline prepare(const Outline& outline) {
  PreparedOutline result{outline, {}, {}};
  std::vector<std::uint32_t> points;
  points.reserve(outline.orders.size());
  std::uint32_t point = 0;
  for (const std::uint32_t count : outline.contours) {
    for (std::uint32_t i = 0; i < count; ++i) {
      points.push_back(point);
      point += outline.orders[points.size() - 1];
    }
    ++point;
  }
  result.nodes.reserve(2 * outline.orders.size());
  std::size_t begin = 0;
  for (const std::uint32_t count : outline.contours) {
    add_nodes(result, points, begin, begin + count);
    begin += count;
  }
  result.map = map_of(result);
  return result;
}

OutlinePlace nearest_on(const PreparedOutline& outline, std::uint32_t node, const PlanePoint& point) {
  const Curve curve = curve_of(outline.outline, outline.nodes[node]);
  OutlinePlace result;
  double best = std::numeric_limits<double>::infinity();
  const auto keep = [&](double w) {
    const PlanePoint foot = point_at(curve, w), offset = foot - point;
    const double square = dot(offset, offset);
    if (result.node != scene::kNone && !(square < best)) return;
    best = square;
    result = {node, w, foot, tangent_at(curve, w)};
  };
  if (const auto w = foot_on_curve(curve, point)) {
    if (curve.size() == 2) return {node, *w, point_at(curve, *w), curve[1] - curve[0]};
    keep(*w);
  } else {
    for_each_foot(curve, point, keep);
  }
  return result;
}

double reach_of(const Outline& outline, const PlanePoint& direction) {
  double farthest = -std::numeric_limits<double>::infinity();
  std::size_t first = 0, curve = 0;
  for (const std::uint32_t count : outline.contours) {
    for (std::uint32_t i = 0; i < count; ++i, ++curve) {
      const Curve points = std::span(outline.points).subspan(first, outline.orders[curve] + std::size_t{1});
      first += outline.orders[curve];
      for_each_farthest(points, direction,
                        [&](double w) { farthest = std::max(farthest, dot(point_at(points, w), direction)); });
    }
    ++first;
  }
  return farthest;
}

}  // namespace isl::render
