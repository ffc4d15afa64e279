// A ray through a Grid: its leaf and inside cells in order, with the stretch of the ray in each (Amanatides and Woo 1987, nested).
// Within a level the next plane on an axis is always (plane − origin) · inverse from the plane's index: nothing accumulates. A
// zero direction component never steps (its planes are at +∞). Stretches join without gaps, since each begins where the last one
// ended.
#if defined(ISL_RENDERER_GRID_GRID_WALK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_GRID_GRID_WALK_INL_H_
#undef ISL_RENDERER_GRID_GRID_WALK_INL_H_
#else
#define ISL_RENDERER_GRID_GRID_WALK_INL_H_
#endif

#include "renderer/grid/grid.h"

#include <hwy/highway.h>

#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// Where the line is within the box, between t0 and t1: [enter, leave], empty if enter > leave. Zero components apart.
struct BoxSpan {
  double enter, leave;
};
HWY_INLINE BoxSpan clip_to_box(const Box& box, const Vec3& origin, const Vec3& direction, double t0, double t1) {
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0) {
      if (!(origin[axis] >= box.min[axis] && origin[axis] <= box.max[axis])) return {1, 0};
      continue;
    }
    const double a = (box.min[axis] - origin[axis]) / direction[axis];
    const double b = (box.max[axis] - origin[axis]) / direction[axis];
    t0 = a < b ? (a > t0 ? a : t0) : (b > t0 ? b : t0);
    t1 = a < b ? (b < t1 ? b : t1) : (a < t1 ? a : t1);
  }
  return {t0, t1};
}

/// Calls visit(cell_index, cell, t_in, t_out) for each leaf and inside cell that the ray meets between t0 and t1 (which lie
/// within the grid's box), in order, until visit returns true. Stretches of no length are left out.
template <class Visit>
HWY_INLINE void walk(const Grid& grid, const Vec3& origin, const Vec3& direction, double t0, double t1, Visit&& visit) {
  struct Level {
    double next[3];  ///< t of the next plane on each axis
    double low[3];   ///< corner, relative to the ray's origin
    int index[3];    ///< of the current cell
    std::uint32_t first;
    int depth;
  };
  // What is the same for all bricks of a depth. Sizes shrink by powers of two, so that nothing here is rounded but `inverse`.
  struct Scale {
    double size[3], inverse_size[3];
  };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Level stack[kMaxGridDepth + 2];
  Scale scales[kMaxGridDepth + 2];
  double inverse[3];
  int step[3], ahead[3];
  for (int axis = 0; axis < 3; ++axis) {
    inverse[axis] = 1 / direction[axis];
    // A component so small that its inverse overflows moves by less than a rounding over any stretch: it is zero.
    if (!std::isfinite(inverse[axis])) inverse[axis] = kInfinity;
    step[axis] = inverse[axis] < 0 ? -1 : 1;
    ahead[axis] = inverse[axis] < 0 ? 0 : 1;
    scales[0].size[axis] = grid.cell_size[axis];
    scales[0].inverse_size[axis] = 1 / grid.cell_size[axis];
    stack[0].low[axis] = grid.low[axis] - origin[axis];
  }
  int scales_known = 1;
  const int top_side[3] = {grid.dimensions[0], grid.dimensions[1], grid.dimensions[2]};
  constexpr int kBrickSides[3] = {kBrickSide, kBrickSide, kBrickSide};

  const auto next_plane = [&](const Level& level, int axis) HWY_ATTR {
    const int plane = level.index[axis] + ahead[axis];
    if (inverse[axis] == kInfinity) return kInfinity;
    return (level.low[axis] + plane * scales[level.depth].size[axis]) * inverse[axis];
  };
  const auto enter = [&](Level& level, const int* side, double t) HWY_ATTR {
    for (int axis = 0; axis < 3; ++axis) {
      const double cell = (t * direction[axis] - level.low[axis]) * scales[level.depth].inverse_size[axis];
      const int index = static_cast<int>(cell);  // towards zero: below zero it is clamped anyway
      level.index[axis] = index < 0 ? 0 : index >= side[axis] ? side[axis] - 1 : index;
      level.next[axis] = next_plane(level, axis);
    }
  };
  const auto nearest_plane = [](const Level& level) HWY_ATTR {
    const int xy = level.next[1] < level.next[0] ? 1 : 0;
    return level.next[2] < level.next[xy] ? 2 : xy;
  };

  Level* level = stack;
  level->first = 0;
  level->depth = 0;
  double t = t0;
  enter(*level, top_side, t);
  for (;;) {
    const int* side = level == stack ? top_side : kBrickSides;
    const std::uint32_t index =
        level->first + static_cast<std::uint32_t>((level->index[2] * side[1] + level->index[1]) * side[0] + level->index[0]);
    const Cell cell = grid.cells[index];
    if (cell.kind() == CellKind::brick) {
      Level& child = level[1];
      child.first = cell.first;
      child.depth = level->depth + 1;
      if (child.depth == scales_known) {
        for (int axis = 0; axis < 3; ++axis) {
          scales[child.depth].size[axis] = scales[level->depth].size[axis] * (1.0 / kBrickSide);
          scales[child.depth].inverse_size[axis] = scales[level->depth].inverse_size[axis] * kBrickSide;
        }
        ++scales_known;
      }
      for (int axis = 0; axis < 3; ++axis) {
        child.low[axis] = level->low[axis] + level->index[axis] * scales[level->depth].size[axis];
      }
      ++level;
      enter(*level, kBrickSides, t);
      continue;
    }
    int axis = nearest_plane(*level);
    const double out = level->next[axis] < t1 ? level->next[axis] : t1;
    if (out > t) {
      if (cell.kind() != CellKind::empty && visit(index, cell, t, out)) return;
      t = out;
    }
    if (t >= t1) return;
    // To the next cell, up a level wherever the ray leaves one. A level's plane may differ from its child's by a rounding;
    // t stays as it is then, so that nothing is skipped.
    for (;;) {
      const int moved = level->index[axis] + step[axis];
      const int end = level == stack ? top_side[axis] : kBrickSide;
      if (static_cast<unsigned>(moved) < static_cast<unsigned>(end)) {
        level->index[axis] = moved;
        break;
      }
      if (level == stack) return;
      --level;
      axis = nearest_plane(*level);
    }
    level->next[axis] = next_plane(*level, axis);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
