// Lays out the top brick of a grid around its content.
#pragma once

#include "renderer/grid/grid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace isl::render {

/// A grid without cells yet: cubic ones, four along the longest side of the content and centred on it. They are wider
/// by 2⁻²⁰, as every cell is. `bounds` must not be empty. `has_endless`: all cells of the brick are in use.
[[nodiscard]] inline Grid top_brick_about(const Box& bounds, bool has_endless) {
  const Vec3 size = bounds.size();
  const double longest = std::max({size.x, size.y, size.z, std::numeric_limits<double>::min()});
  Grid grid;
  grid.bounds = bounds;
  grid.cell_size = longest * (1 + 0x1p-20) / kBrickSide;
  Vec3 half;
  for (int axis = 0; axis < 3; ++axis) {
    const double cells = std::ceil(size[axis] / grid.cell_size);
    const int needed = cells < kBrickSide ? std::max(static_cast<int>(cells), 1) : kBrickSide;
    grid.dimensions[axis] = has_endless ? kBrickSide : needed;
    half[axis] = 0.5 * grid.cell_size * grid.dimensions[axis];
  }
  grid.box = Box(bounds.center() - half, bounds.center() + half);
  // A walk (grid_walk-inl.h) adds up a cell's corner relative to the ray's origin, level by level, and divides its
  // distance by the direction: some 20 roundings of 2⁻⁵³ of numbers up to twice the largest coordinate.
  double farthest = 0;
  for (int axis = 0; axis < 3; ++axis)
    farthest = std::max({farthest, std::abs(grid.box.min[axis]), std::abs(grid.box.max[axis])});
  grid.rounding = 0x1p-47 * farthest;
  return grid;
}

/// True if a cell of the top brick is within the grid's box.
[[nodiscard]] inline bool is_in_use(const Grid& grid, std::uint32_t index) {
  return std::cmp_less(index % kBrickSide, grid.dimensions[0]) &&
         std::cmp_less(index / kBrickSide % kBrickSide, grid.dimensions[1]) &&
         std::cmp_less(index / (kBrickSide * kBrickSide), grid.dimensions[2]);
}

/// The boxes of items, by item, wider by what rounding can do to them: they come from some ten roundings of 2⁻⁵³.
/// `items` ascend.
template <class Classifier>
[[nodiscard]] std::vector<Box> widened_boxes(const Classifier& classifier, std::span<const std::uint32_t> items) {
  std::vector<Box> boxes(items.back() + std::size_t{1});
  for (const std::uint32_t item : items) {
    Box& box = boxes[item];
    box = classifier.item_bounds(item);
    for (int axis = 0; axis < 3; ++axis) {
      const double slack = 0x1p-48 * std::max(std::abs(box.min[axis]), std::abs(box.max[axis]));
      if (!(slack < std::numeric_limits<double>::infinity())) continue;
      box.min[axis] -= slack;
      box.max[axis] += slack;
    }
  }
  return boxes;
}

}  // namespace isl::render
