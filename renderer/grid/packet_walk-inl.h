// Walks eight rays through a Grid together: visits every leaf and inside cell that any of them meets, once, with the
// stretch of each ray in it.
//
// Rays whose directions have the same signs share an order of a brick's cells in which each ray meets its own cells:
// slab by slab, axis within axis, counted in the rays' direction. The stretches of all rays in the four slabs of each
// axis tell which slabs are met at all. Of the cells in those that are not empty, the stretches are the common parts of
// those in three slabs. As long as the rays stay together, that costs less than letting each of them step from cell to
// cell (grid_walk-inl.h), and no ray can get out of step with the others.
//
// A plane between two cells of a brick has one t for both, and a brick's outer planes are ignored in favour of its
// parent's. Therefore stretches join without gaps.
#if defined(ISL_RENDERER_GRID_PACKET_WALK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_GRID_PACKET_WALK_INL_H_
#undef ISL_RENDERER_GRID_PACKET_WALK_INL_H_
#else
#define ISL_RENDERER_GRID_PACKET_WALK_INL_H_
#endif

#include "renderer/grid/grid.h"
#include "renderer/grid/grid_walk-inl.h"
#include "renderer/solids/octet_vector-inl.h"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// Values of the directions of eight rays that boxes and cells are met with.
struct PacketAxes {
  Octet inverse[3];
  /// Rays that do not move along the axis. A component so small that its inverse overflows moves the ray by less than a
  /// rounding over any stretch, so it counts as zero.
  OctetMask flat[3];

  HWY_INLINE explicit PacketAxes(const OctetVector& direction) {
    const Octet* const along[] = {&direction.x, &direction.y, &direction.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      inverse[axis] = Octet(1.0) / *along[axis];
      flat[axis] = abs(inverse[axis]) >= Octet(std::numeric_limits<double>::infinity());
    }
  }
};

/// The parts of eight lines between two t each; a line without one has enter > leave.
struct OctetSpans {
  Octet enter, leave;
};

/// As clip_to_box of one line (grid_walk-inl.h), from 0 to t_max.
[[nodiscard]] HWY_INLINE OctetSpans clip_to_box(const Box& box, const OctetVector& origin, const PacketAxes& axes,
                                                const Octet& t_max) {
  const Octet* const from[] = {&origin.x, &origin.y, &origin.z};
  Octet enter(0.0), leave = t_max;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<int>(axis);
    const Octet to_min = Octet(box.min[i]) - *from[axis], to_max = Octet(box.max[i]) - *from[axis];
    const Octet a = to_min * axes.inverse[axis], b = to_max * axes.inverse[axis];
    const OctetMask is_beside = axes.flat[axis] & ((to_min > Octet(0.0)) | (to_max < Octet(0.0)));
    enter = select(axes.flat[axis], enter, max(enter, min(a, b)));
    leave = select(is_beside, Octet(-1.0), select(axes.flat[axis], leave, min(leave, max(a, b))));
  }
  return {enter, leave};
}

/// The rays of eight that begin in the box.
[[nodiscard]] HWY_INLINE OctetMask begin_in(const Box& box, const OctetVector& origin) {
  const Octet* const from[] = {&origin.x, &origin.y, &origin.z};
  OctetMask within = all_lanes();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<int>(axis);
    within = within & (*from[axis] >= Octet(box.min[i])) & (*from[axis] <= Octet(box.max[i]));
  }
  return within;
}

/// By axis and bits of its slabs, the bits of a brick's cells in these.
inline constexpr auto kCellsOf = [] {
  std::array<std::array<std::uint64_t, 1U << kBrickSide>, 3> cells{};
  for (unsigned axis = 0; axis < 3; ++axis) {
    for (unsigned slabs = 0; slabs < cells[axis].size(); ++slabs) {
      for (unsigned cell = 0; cell < kBrickCells; ++cell)
        cells[axis][slabs] |= std::uint64_t{slabs >> (cell >> (2 * axis) & 3) & 1} << cell;
    }
  }
  return cells;
}();

/// Visit: OctetMask visit(std::uint32_t index, const Cell&, const OctetMask& lanes, const Octet& enter, const Octet&
/// leave). It returns the rays that are done.
template <class Visit>
class PacketWalk {
 public:
  PacketWalk(const Grid& grid, const OctetVector& origin, const PacketAxes& axes, const Visit& visit)
      : grid_(grid), visit_(visit), axes_(axes) {
    const Octet* const from[] = {&origin.x, &origin.y, &origin.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      backward_[axis] = bits(and_not(axes.flat[axis], axes.inverse[axis] < Octet(0.0)));
      has_flat_[axis] = !none(axes.flat[axis]);
      low_[axis] = Octet(grid.box.min[static_cast<int>(axis)]) - *from[axis];
    }
  }

  /// Walks the rays whose bits are set in `lanes`, between t0 and t1, which lie within the grid's box.
  void walk(std::uint32_t lanes, const Octet& t0, const Octet& t1) {
    while (lanes != 0) {
      std::uint32_t alike = lanes;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool is_backward = (backward_[axis] >> std::countr_zero(lanes) & 1) != 0;
        alike &= is_backward ? backward_[axis] : ~backward_[axis];
        is_backward_[axis] = is_backward;
        mirror_ = (mirror_ & ~(3U << (2 * axis))) | (is_backward ? 3U << (2 * axis) : 0);
      }
      active_ = mask_of(alike);
      walk_into({low_[0], low_[1], low_[2]}, 0, grid_.cell_size, active_, t0, t1);
      lanes &= ~alike;
    }
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  /// The stretches of the rays in the four slabs of an axis, in the order in which they are met.
  struct Slabs {
    Octet enter[kBrickSide], leave[kBrickSide];
    unsigned met = 0;  ///< bits of the slabs in which some ray has a stretch
  };

  /// The t at which rays meet a plane across the axis, at this distance from their origins. Rays along the plane are
  /// behind it or before it all the way.
  [[nodiscard]] HWY_INLINE Octet at_plane(std::size_t axis, const Octet& distance) const {
    const Octet t = distance * axes_.inverse[axis];
    if (!has_flat_[axis]) [[likely]]
      return t;
    const Octet never = select(distance <= Octet(0.0), Octet(-kInfinity), Octet(kInfinity));
    return select(axes_.flat[axis], never, t);
  }

  HWY_INLINE void set_slabs(std::size_t axis, const Octet& low, double size, const OctetMask& lanes, const Octet& t0,
                            const Octet& t1, Slabs& slabs) const {
    Octet enter = t0;
    for (int i = 0; i < kBrickSide; ++i) {
      slabs.enter[i] = enter;
      Octet leave = t1;
      if (i < kBrickSide - 1) {
        const Octet at = low + Octet((is_backward_[axis] ? kBrickSide - 1 - i : i + 1) * size);
        const Octet plane = at_plane(axis, at);
        leave = min(t1, plane);
        enter = max(t0, plane);
      }
      slabs.leave[i] = leave;
      slabs.met |= none(lanes & (slabs.enter[i] < leave)) ? 0 : 1U << i;
    }
  }

  /// A brick's cells that are not empty, with bits in the order in which they are met.
  [[nodiscard]] HWY_INLINE std::uint64_t in_order(std::uint64_t occupied) const {
    const auto swapped = [&](int by, std::uint64_t low) { occupied = (occupied >> by & low) | (occupied & low) << by; };
    if (is_backward_[0]) {
      swapped(1, 0x5555555555555555);
      swapped(2, 0x3333333333333333);
    }
    if (is_backward_[1]) {
      swapped(4, 0x0f0f0f0f0f0f0f0f);
      swapped(8, 0x00ff00ff00ff00ff);
    }
    if (is_backward_[2]) {
      swapped(16, 0x0000ffff0000ffff);
      swapped(32, 0x00000000ffffffff);
    }
    return occupied;
  }

  void walk_into(const OctetVector& low, std::uint32_t first, double size, const OctetMask& lanes, const Octet& t0,
                 const Octet& t1) {
    const std::uint32_t rays = bits(lanes);
    if (std::has_single_bit(rays)) {
      walk_alone(static_cast<std::size_t>(std::countr_zero(rays)), low, first, size, lanes, t0, t1);
    } else {
      walk_brick(low, first, size, lanes, t0, t1);
    }
  }

  /// One ray steps from cell to cell.
  void walk_alone(std::size_t lane, const OctetVector& low, std::uint32_t first, double size, const OctetMask& lanes,
                  const Octet& t0, const Octet& t1) {
    alignas(64) double from[8][kOctet];
    store(low.x, from[0]);
    store(low.y, from[1]);
    store(low.z, from[2]);
    for (std::size_t axis = 0; axis < 3; ++axis) store(axes_.inverse[axis], from[3 + axis]);
    store(t0, from[6]);
    store(t1, from[7]);
    const BrickFromOrigin brick{{from[0][lane], from[1][lane], from[2][lane]}, size, first};
    const WalkAxes axes(from[3][lane], from[4][lane], from[5][lane]);
    render::HWY_NAMESPACE::walk_brick(grid_, brick, axes, from[6][lane], from[7][lane],
                                      [&](std::uint32_t index, const Cell& cell, double enter, double leave) HWY_ATTR {
                                        const OctetMask done = visit_(index, cell, lanes, Octet(enter), Octet(leave));
                                        active_ = and_not(done, active_);
                                        return !none(done);
                                      });
  }

  void walk_brick(const OctetVector& low, std::uint32_t first, double size, const OctetMask& lanes, const Octet& t0,
                  const Octet& t1) {
    Slabs in_x, in_y, in_z;
    set_slabs(0, low.x, size, lanes, t0, t1, in_x);
    set_slabs(1, low.y, size, lanes, t0, t1, in_y);
    set_slabs(2, low.z, size, lanes, t0, t1, in_z);
    std::uint64_t left = in_order(grid_.occupied[first / kBrickCells]) & kCellsOf[0][in_x.met] & kCellsOf[1][in_y.met] &
                         kCellsOf[2][in_z.met];
    for (; left != 0; left &= left - 1) {
      const auto met = static_cast<std::uint32_t>(std::countr_zero(left));
      const std::uint32_t i = met & 3, j = met >> 2 & 3, k = met >> 4;
      Octet enter = max(in_x.enter[i], max(in_y.enter[j], in_z.enter[k]));
      Octet leave = min(in_x.leave[i], min(in_y.leave[j], in_z.leave[k]));
      OctetMask present = lanes & active_ & (enter < leave);
      if (none(present)) continue;
      const std::uint32_t in_brick = met ^ mirror_, index = first + in_brick;
      const Cell cell = grid_.cells[index];
      if (cell.is_trimmed) {
        trim(cell.core, low, in_brick, size, enter, leave);
        present = present & (enter < leave);
        if (none(present)) continue;
      }
      if (cell.kind() == CellKind::brick) {
        const auto corner = [&](const Octet& from, std::uint32_t slab) HWY_ATTR { return from + Octet(slab * size); };
        walk_into({corner(low.x, in_brick & 3), corner(low.y, in_brick >> 2 & 3), corner(low.z, in_brick >> 4)},
                  cell.first, size * (1.0 / kBrickSide), present, enter, leave);
      } else {
        active_ = and_not(visit_(index, cell, present, enter, leave), active_);
      }
      if (none(active_)) return;
    }
  }

  /// Shortens stretches in a cell of a brick to its core. A stretch that begins with the ray keeps its beginning: rays
  /// that start on a surface know that they do.
  HWY_INLINE void trim(const CellCore& core, const OctetVector& low, std::uint32_t in_brick, double size, Octet& enter,
                       Octet& leave) const {
    const Octet* const corner[] = {&low.x, &low.y, &low.z};
    Octet from = enter;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const CorePlanes planes = core_planes(core, axis, in_brick >> (2 * axis) & 3);
      const bool is_backward = is_backward_[axis];
      from = max(from, at_plane(axis, *corner[axis] + Octet((is_backward ? planes.high : planes.low) * size)));
      leave = min(leave, at_plane(axis, *corner[axis] + Octet((is_backward ? planes.low : planes.high) * size)));
    }
    enter = select(enter > Octet(0.0), from, enter);
  }

  const Grid& grid_;
  const Visit& visit_;
  const PacketAxes& axes_;
  Octet low_[3];
  std::uint32_t backward_[3]{};  ///< bits of the rays that move against the axis
  bool has_flat_[3]{};           ///< true if some ray does not move along the axis
  bool is_backward_[3]{};        ///< true if the rays that are walked together move against the axis
  std::uint32_t mirror_ = 0;     ///< turns the number of a cell in the order in which it is met into its own
  OctetMask active_;             ///< rays that are not done
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
