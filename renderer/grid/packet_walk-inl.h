// Walks eight rays through a Grid together: visits every leaf and inside cell that any of them meets, once, with the
// stretch of each ray in it.
//
// Rays whose directions have the same signs share an order of a brick's cells in which each ray meets its own cells:
// slab by slab, axis within axis, counted in the rays' direction. For every slab, row and cell of a brick, the
// stretches of all rays in it are a minimum and a maximum with the planes, and where no stretch is left everything
// inside is skipped. As long as the rays stay together, that costs less than letting each of them step from cell to
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
#include "renderer/solids/octet_vector-inl.h"

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
      }
      active_ = mask_of(alike);
      walk_brick({low_[0], low_[1], low_[2]}, 0, grid_.cell_size, active_, t0, t1);
      lanes &= ~alike;
    }
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  struct Corner {
    Octet x, y, z;
  };
  /// t at which the rays enter the slabs 1 to 3 of an axis, in the order in which they meet them.
  struct Planes {
    Octet t[kBrickSide - 1];
  };

  HWY_INLINE Planes planes(std::size_t axis, const Octet& low, double size) const {
    Planes planes;
    for (int i = 1; i < kBrickSide; ++i) {
      const Octet at = low + Octet((is_backward_[axis] ? kBrickSide - i : i) * size);
      const Octet never = select(at <= Octet(0.0), Octet(-kInfinity), Octet(kInfinity));
      planes.t[i - 1] = select(axes_.flat[axis], never, at * axes_.inverse[axis]);
    }
    return planes;
  }

  struct Stretch {
    Octet enter, leave;
    OctetMask lanes;
  };
  /// The part of a stretch in slab i.
  HWY_INLINE Stretch within(const Stretch& s, const Planes& planes, int i) const {
    const Octet enter = i > 0 ? max(s.enter, planes.t[i - 1]) : s.enter;
    const Octet leave = i < kBrickSide - 1 ? min(s.leave, planes.t[i]) : s.leave;
    return {enter, leave, s.lanes & active_ & (enter < leave)};
  }
  [[nodiscard]] unsigned slab(std::size_t axis, int i) const {
    return static_cast<unsigned>(is_backward_[axis] ? kBrickSide - 1 - i : i);
  }

  void walk_brick(const Corner& low, std::uint32_t first, double size, const OctetMask& lanes, const Octet& t0,
                  const Octet& t1) {
    const std::uint64_t occupied = grid_.occupied[first / kBrickCells];
    const Planes in_x = planes(0, low.x, size), in_y = planes(1, low.y, size), in_z = planes(2, low.z, size);
    const Stretch all{t0, t1, lanes};
    for (int k = 0; k < kBrickSide; ++k) {
      const unsigned z = slab(2, k);
      const std::uint64_t in_slab = occupied >> (16 * z) & 0xffff;
      if (in_slab == 0) continue;
      const Stretch slab_stretch = within(all, in_z, k);
      if (none(slab_stretch.lanes)) continue;
      for (int j = 0; j < kBrickSide; ++j) {
        const unsigned y = slab(1, j);
        const std::uint64_t in_row = in_slab >> (4 * y) & 0xf;
        if (in_row == 0) continue;
        const Stretch row_stretch = within(slab_stretch, in_y, j);
        if (none(row_stretch.lanes)) continue;
        for (int i = 0; i < kBrickSide; ++i) {
          const unsigned x = slab(0, i);
          if ((in_row >> x & 1) == 0) continue;
          const Stretch stretch = within(row_stretch, in_x, i);
          if (none(stretch.lanes)) continue;
          const std::uint32_t index = first + (x | y << 2 | z << 4);
          const Cell cell = grid_.cells[index];
          if (cell.kind() == CellKind::brick) {
            walk_brick({low.x + Octet(x * size), low.y + Octet(y * size), low.z + Octet(z * size)}, cell.first,
                       size * (1.0 / kBrickSide), stretch.lanes, stretch.enter, stretch.leave);
          } else {
            active_ = and_not(visit_(index, cell, stretch.lanes, stretch.enter, stretch.leave), active_);
          }
        }
      }
    }
  }

  const Grid& grid_;
  const Visit& visit_;
  const PacketAxes& axes_;
  Octet low_[3];
  std::uint32_t backward_[3]{};  ///< bits of the rays that move against the axis
  bool is_backward_[3]{};        ///< true if the rays that are walked together move against the axis
  OctetMask active_;             ///< rays that are not done
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
