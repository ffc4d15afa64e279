// Walks one ray through a Grid: visits leaf and inside cells in order, with the stretch of the ray in each. On entering
// a brick, the t of each of its planes is computed once, from the plane's own number and not from the plane before, so
// that no error accumulates; its outer planes have the t that they have in the brick around it. From then on, walking
// is counting (Amanatides and Woo 1987, nested). A zero direction component never steps, because its planes are at +∞.
// Stretches join without gaps, since each begins where the last one ended.
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
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// The part of the line between t0 and t1 that is within the box: [enter, leave], empty if enter > leave. Axes along
/// which the line does not move are handled separately.
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

/// Values of a ray that the walk needs in every brick. Slabs are counted in the order in which the ray meets them, so
/// that every step adds one; `mirror` turns a position counted so into that of the cell.
struct WalkAxes {
  double inverse[3];  ///< 1 / direction; +∞ on an axis along which the ray does not move
  unsigned mirror = 0;

  HWY_INLINE explicit WalkAxes(const Vec3& direction) : WalkAxes(1 / direction.x, 1 / direction.y, 1 / direction.z) {}
  /// A component so small that its inverse overflows moves the ray by less than a rounding over any stretch, so it
  /// counts as zero.
  HWY_INLINE WalkAxes(double per_x, double per_y, double per_z) : inverse{per_x, per_y, per_z} {
    for (int axis = 0; axis < 3; ++axis) {
      if (!std::isfinite(inverse[axis])) inverse[axis] = std::numeric_limits<double>::infinity();
      if (inverse[axis] < 0) mirror |= 3U << (2 * axis);
    }
  }
};

/// A brick that the ray is in.
struct WalkLevel {
  double leave[3][kBrickSide];  ///< t at which the ray leaves each slab of each axis
  double low[3];                ///< corner, relative to the ray's origin
  double end;                   ///< t at which the ray leaves the brick's core
  unsigned position;            ///< two bits an axis: the slab it is in
  std::uint32_t first;          ///< the brick's first cell
};

/// `outer`: t at which the ray leaves the brick on each axis, as the brick around it has it.
HWY_INLINE void enter_brick(const WalkAxes& axes, double size, double t, const double (&outer)[3], WalkLevel& level) {
  level.position = 0;
  for (unsigned axis = 0; axis < 3; ++axis) {
    double* const leave = level.leave[axis];
    const double inverse = axes.inverse[axis], low = level.low[axis];
    unsigned slab;
    if (inverse == std::numeric_limits<double>::infinity()) {
      for (int i = 0; i < kBrickSide; ++i) leave[i] = inverse;
      slab = (size <= -low) + (2 * size <= -low) + (3 * size <= -low);
    } else {
      const bool backward = inverse < 0;
      const double from = backward ? low + 3 * size : low + size, by = backward ? -size : size;
      for (int i = 0; i < kBrickSide - 1; ++i) leave[i] = (from + i * by) * inverse;
      leave[kBrickSide - 1] = outer[axis];
      slab = (leave[0] <= t) + (leave[1] <= t) + (leave[2] <= t);
    }
    level.position |= slab << (2 * axis);
  }
}

/// A brick, seen from a ray's origin.
struct BrickFromOrigin {
  double low[3];        ///< its corner
  double size;          ///< of its cells
  std::uint32_t first;  ///< its first cell
};

/// The part of a ray between two t.
struct Stretch {
  double enter, leave;
};
/// The part of a stretch in the core of a cell: number `in_brick` of the brick with this corner and cells of this size.
[[nodiscard]] HWY_INLINE Stretch in_core(const CellCore& core, const double (&low)[3], unsigned in_brick, double size,
                                         const WalkAxes& axes, Stretch stretch) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (unsigned axis = 0; axis < 3; ++axis) {
    const CorePlanes planes = core_planes(core, axis, in_brick >> (2 * axis) & 3);
    const double near = low[axis] + planes.low * size, far = low[axis] + planes.high * size;
    const double inverse = axes.inverse[axis];
    double enter = near * inverse, leave = far * inverse;
    if (inverse == kInfinity) {  // it is between the two planes all the way or nowhere
      enter = near <= 0 ? -kInfinity : kInfinity;
      leave = far <= 0 ? -kInfinity : kInfinity;
    } else if (inverse < 0) {
      std::swap(enter, leave);
    }
    stretch.enter = enter > stretch.enter ? enter : stretch.enter;
    stretch.leave = leave < stretch.leave ? leave : stretch.leave;
  }
  return stretch;
}

/// Calls visit(cell_index, cell, t_in, t_out) for each leaf and inside cell that the ray meets in the brick between t0
/// and t1, which lie within it, in order, until visit returns true. Stretches of no length are left out. A stretch that
/// begins at t0 keeps its beginning, wherever the cell's core is: rays that start on a surface know that they do.
template <class Visit>
HWY_INLINE void walk_brick(const Grid& grid, const BrickFromOrigin& brick, const WalkAxes& axes, double t0, double t1,
                           Visit&& visit) {
  WalkLevel stack[kMaxGridDepth + 2];
  WalkLevel* level = stack;
  for (int axis = 0; axis < 3; ++axis) level->low[axis] = brick.low[axis];
  double size = brick.size, t = t0;
  // The t at which the ray leaves its slab on each axis is kept in registers: writing it to memory and reading it back
  // would take half of the time.
  double next_x = 0, next_y = 0, next_z = 0;
  const auto read_next = [&]() HWY_ATTR {
    next_x = level->leave[0][level->position & 3];
    next_y = level->leave[1][level->position >> 2 & 3];
    next_z = level->leave[2][level->position >> 4];
  };
  level->first = brick.first;
  level->end = t1;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  enter_brick(axes, size, t, {kInfinity, kInfinity, kInfinity}, *level);  // only t1 ends the walk
  read_next();
  double end = t1;
  for (;;) {
    const unsigned in_brick = level->position ^ axes.mirror;
    unsigned axis = next_y < next_x ? 1 : 0;
    double nearest = next_y < next_x ? next_y : next_x;
    axis = next_z < nearest ? 2 : axis;
    nearest = next_z < nearest ? next_z : nearest;
    const double out = nearest < end ? nearest : end;
    if (grid.occupied[level->first / kBrickCells] >> in_brick & 1) {
      const std::uint32_t index = level->first + in_brick;
      const Cell cell = grid.cells[index];
      Stretch stretch{t, out};
      if (cell.is_trimmed) {
        stretch = in_core(cell.core, level->low, in_brick, size, axes, stretch);
        if (t == t0) stretch.enter = t0;
      }
      if (stretch.enter < stretch.leave) {
        if (cell.kind() == CellKind::brick) {
          WalkLevel& child = level[1];
          child.first = cell.first;
          for (unsigned a = 0; a < 3; ++a) child.low[a] = level->low[a] + (in_brick >> (2 * a) & 3) * size;
          size *= 1.0 / kBrickSide;
          t = stretch.enter;
          child.end = end = stretch.leave;
          enter_brick(axes, size, t, {next_x, next_y, next_z}, child);
          ++level;
          read_next();
          continue;
        }
        if (visit(index, cell, stretch.enter, stretch.leave)) return;
      }
    }
    t = out > t ? out : t;
    // Goes to the next cell, and up a level wherever the ray leaves a brick or its core.
    for (;;) {
      const unsigned slab = level->position >> (2 * axis) & 3;
      if (t < end && slab + 1 < kBrickSide) {
        level->position += 1u << (2 * axis);
        const double leave = level->leave[axis][slab + 1];
        next_x = axis == 0 ? leave : next_x;
        next_y = axis == 1 ? leave : next_y;
        next_z = axis == 2 ? leave : next_z;
        break;
      }
      if (level == stack) return;
      --level;
      size *= kBrickSide;
      end = level->end;
      read_next();
      axis = next_y < next_x ? 1 : 0;
      nearest = next_y < next_x ? next_y : next_x;
      axis = next_z < nearest ? 2 : axis;
      nearest = next_z < nearest ? next_z : nearest;
      const double left = nearest < end ? nearest : end;
      t = left > t ? left : t;
    }
  }
}

/// The same for a whole grid.
template <class Visit>
HWY_INLINE void walk(const Grid& grid, const Vec3& origin, const Vec3& direction, double t0, double t1, Visit&& visit) {
  BrickFromOrigin top{{}, grid.cell_size, 0};
  for (int axis = 0; axis < 3; ++axis) top.low[axis] = grid.box.min[axis] - origin[axis];
  walk_brick(grid, top, WalkAxes(direction), t0, t1, visit);
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
