// Octets read back from PacketMemory, a ray in every lane: the forms of lane_columns-inl.h, and the one walk over runs, kernels
// and rows.
#if defined(ISL_RENDERER_FIELDS_PACKET_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_PACKET_ROWS_INL_H_
#undef ISL_RENDERER_FIELDS_PACKET_ROWS_INL_H_
#else
#define ISL_RENDERER_FIELDS_PACKET_ROWS_INL_H_
#endif

#include "renderer/fields/kernels/kernels-inl.h"
#include "renderer/fields/lane_columns-inl.h"
#include "renderer/fields/packet_memory.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

[[nodiscard]] HWY_INLINE QuadraticLanes quadratic_of(const PacketRow& row) {
  return {load(row.along[0]), load(row.along[1]), load(row.along[2]), Octet(row.amplitude)};
}
HWY_INLINE void store_row(const QuadraticLanes& lanes, PacketRow& row) {
  store(lanes.v0, row.along[0]);
  store(lanes.kappa, row.along[1]);
  store(lanes.middle, row.along[2]);
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
  store(lanes.x0, row.along[0]);
  store(lanes.dx, row.along[1]);
  store(lanes.n0, row.along[2]);
  store(lanes.n2, row.along[3]);
  store(lanes.middle, row.along[4]);
}

[[nodiscard]] HWY_INLINE CircleLanes circle_of(const PacketRow& row) {
  return {load(row.along[0]), load(row.along[1]),  load(row.along[2]),  load(row.along[3]),
          load(row.along[4]), Octet(row.shape[0]), Octet(row.shape[1]), Octet(row.amplitude)};
}
HWY_INLINE void store_row(const CircleLanes& lanes, PacketRow& row) {
  store(lanes.z0, row.along[0]);
  store(lanes.dz, row.along[1]);
  store(lanes.n0, row.along[2]);
  store(lanes.n2, row.along[3]);
  store(lanes.middle, row.along[4]);
}

[[nodiscard]] HWY_INLINE SegmentLanes segment_of(const PacketRow& row) {
  return {load(row.along[0]), load(row.along[1]), load(row.along[2]),  load(row.along[3]),
          load(row.along[4]), load(row.along[5]), Octet(row.shape[0]), Octet(row.amplitude)};
}
HWY_INLINE void store_row(const SegmentLanes& lanes, PacketRow& row) {
  store(lanes.before0, row.along[0]);
  store(lanes.behind0, row.along[1]);
  store(lanes.dx, row.along[2]);
  store(lanes.n0, row.along[3]);
  store(lanes.n2, row.along[4]);
  store(lanes.middle, row.along[5]);
}

[[nodiscard]] HWY_INLINE RingLanes ring_of(const PacketRow& row) {
  return {load(row.along[0]), load(row.along[1]),  load(row.along[2]), load(row.along[3]),
          load(row.along[4]), Octet(row.shape[0]), Octet(row.amplitude)};
}
HWY_INLINE void store_row(const RingLanes& lanes, PacketRow& row) {
  store(lanes.z0, row.along[0]);
  store(lanes.dz, row.along[1]);
  store(lanes.n0, row.along[2]);
  store(lanes.n2, row.along[3]);
  store(lanes.middle, row.along[4]);
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
