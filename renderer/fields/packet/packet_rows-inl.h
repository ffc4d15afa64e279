// Octets read back from PacketMemory, a ray in every lane: the forms of lane_columns-inl.h, and the one walk over runs, kernels
// and rows.
#if defined(ISL_RENDERER_FIELDS_PACKET_PACKET_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_PACKET_PACKET_ROWS_INL_H_
#undef ISL_RENDERER_FIELDS_PACKET_PACKET_ROWS_INL_H_
#else
#define ISL_RENDERER_FIELDS_PACKET_PACKET_ROWS_INL_H_
#endif

#include "renderer/fields/kernels/kernels-inl.h"
#include "renderer/fields/packet/packet_memory.h"
#include "renderer/fields/ray/lane_columns-inl.h"

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// What differs from ray to ray, in the order of LaneMemory's columns.
template <class... Columns>
HWY_INLINE void store_along(PacketRow& row, const Columns&... columns) {
  std::size_t i = 0;
  (store(columns, row.along[i++]), ...);
}

[[nodiscard]] HWY_INLINE QuadraticLanes quadratic_of(const PacketRow& row) {
  return {load(row.along[0]), load(row.along[1]), load(row.along[2]), Octet(row.amplitude)};
}
HWY_INLINE void store_row(const QuadraticLanes& lanes, PacketRow& row) {
  store_along(row, lanes.v0, lanes.kappa, lanes.middle);
}

/// Where the quadratics of a row hold.
struct PieceBorders {
  Octet begin, end;
};
[[nodiscard]] HWY_INLINE PieceBorders borders_of(const PacketRow& row) { return {load(row.along[3]), load(row.along[4])}; }

[[nodiscard]] HWY_INLINE ConeLanes cone_of(const PacketRow& row) {
  return {load(row.along[0]),   load(row.along[1]),  load(row.along[2]),  load(row.along[3]),  load(row.along[4]),
          Octet(row.shape[0]), Octet(row.shape[1]), Octet(row.shape[2]), Octet(row.amplitude)};
}
HWY_INLINE void store_row(const ConeLanes& lanes, PacketRow& row) {
  store_along(row, lanes.x0, lanes.dx, lanes.n0, lanes.n2, lanes.middle);
}

[[nodiscard]] HWY_INLINE CircleLanes circle_of(const PacketRow& row) {
  return {load(row.along[0]), load(row.along[1]),  load(row.along[2]),  load(row.along[3]),
          load(row.along[4]), Octet(row.shape[0]), Octet(row.shape[1]), Octet(row.amplitude)};
}
HWY_INLINE void store_row(const CircleLanes& lanes, PacketRow& row) {
  store_along(row, lanes.z0, lanes.dz, lanes.n0, lanes.n2, lanes.middle);
}

[[nodiscard]] HWY_INLINE SegmentLanes segment_of(const PacketRow& row) {
  return {load(row.along[0]), load(row.along[1]), load(row.along[2]),  load(row.along[3]),
          load(row.along[4]), load(row.along[5]), Octet(row.shape[0]), Octet(row.amplitude)};
}
HWY_INLINE void store_row(const SegmentLanes& lanes, PacketRow& row) {
  store_along(row, lanes.before0, lanes.behind0, lanes.dx, lanes.n0, lanes.n2, lanes.middle);
}

[[nodiscard]] HWY_INLINE RingLanes ring_of(const PacketRow& row) {
  return {load(row.along[0]), load(row.along[1]),  load(row.along[2]), load(row.along[3]),
          load(row.along[4]), Octet(row.shape[0]), Octet(row.amplitude)};
}
HWY_INLINE void store_row(const RingLanes& lanes, PacketRow& row) {
  store_along(row, lanes.z0, lanes.dz, lanes.n0, lanes.n2, lanes.middle);
}

/// Calls the visitor's
///   add_points(kernel, lanes)              quadratics that hold everywhere
///   add_pieces(kernel, lanes, borders)     and those that do not
///   add_shape(kernel, run, lanes)          cones and circles
///   add_curve(window, lanes)               convolved segments and rings
/// for every row.
template <class Visitor>
HWY_INLINE void visit_rows(const PacketMemory& memory, Visitor& visitor) {
  for (const PacketRun& run : memory.runs) {
    const PacketRow* const begin = memory.rows.data() + run.first;
    const PacketRow* const end = memory.rows.data() + run.last;
    if (run.form == PacketForm::segments || run.form == PacketForm::rings) {
      with_window(*run.kernel, [&](const auto& window) HWY_ATTR {
        for (const PacketRow* row = begin; row != end; ++row) {
          if (run.form == PacketForm::segments) visitor.add_curve(window, segment_of(*row));
          if (run.form == PacketForm::rings) visitor.add_curve(window, ring_of(*row));
        }
      });
      continue;
    }
    with_kernel(*run.kernel, [&](const auto& kernel) HWY_ATTR {
      switch (run.form) {
        case PacketForm::points:
          for (const PacketRow* row = begin; row != end; ++row) visitor.add_points(kernel, quadratic_of(*row));
          break;
        case PacketForm::pieces:
          for (const PacketRow* row = begin; row != end; ++row) {
            visitor.add_pieces(kernel, quadratic_of(*row), borders_of(*row));
          }
          break;
        case PacketForm::cones:
          for (const PacketRow* row = begin; row != end; ++row) visitor.add_shape(kernel, run, cone_of(*row));
          break;
        default:
          for (const PacketRow* row = begin; row != end; ++row) visitor.add_shape(kernel, run, circle_of(*row));
          break;
      }
    });
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
