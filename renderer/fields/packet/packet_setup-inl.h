// Lays out the fields of a cell's list for eight rays, one row for each field, and drops fields that cannot reach the
// stretch of any of the rays. For skeletons with pieces, a row holds the n-th piece along each ray; these may be
// different pieces of the skeleton, since the rays cut it in different orders.
#if defined(ISL_RENDERER_FIELDS_PACKET_PACKET_SETUP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_PACKET_PACKET_SETUP_INL_H_
#undef ISL_RENDERER_FIELDS_PACKET_PACKET_SETUP_INL_H_
#else
#define ISL_RENDERER_FIELDS_PACKET_PACKET_SETUP_INL_H_
#endif

#include "renderer/fields/convolutions/curve_field.h"
#include "renderer/fields/packet/ray_packet.h"
#include "renderer/fields/ray/gather-inl.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class PacketSetup {
 public:
  using Memory = PacketMemory;
  using Number = Octet;
  using Sums = SetupSums<Octet, Octet>;

  /// Sets up for the rays in these lanes only.
  HWY_INLINE PacketSetup(PacketMemory& memory, const RayPacket& rays, const OctetMask& lanes)
      : m_(memory), rays_(rays), lanes_(lanes), t0_(load(rays.t0)), t1_(load(rays.t1)) {}

  [[nodiscard]] HWY_INLINE Sums gather_list(const ComponentTable& table, const std::uint32_t* items,
                                            std::uint32_t count) {
    gather_fields(*this, m_, table, items, count);
    return sums_;
  }
  [[nodiscard]] std::uint32_t rows() const { return rows_; }

  /// Each lane's own sum: the lanes belong to different rays.
  [[nodiscard]] static HWY_INLINE const Octet& total(const Octet& x) { return x; }

  template <class Kernel>
  HWY_INLINE void add_points(const Kernel& kernel, const ListedFields& fields) {
    begin(fields, fields.count);
    const ComponentTable& table = fields.table;
    const Octet ox = load(rays_.origin[0]), oy = load(rays_.origin[1]), oz = load(rays_.origin[2]);
    const Octet dx = load(rays_.direction[0]), dy = load(rays_.direction[1]), dz = load(rays_.direction[2]);
    const Octet dd = dx * dx + dy * dy + dz * dz, inverse_dd = Octet(1.0) / dd;
    for (std::uint32_t i = 0; i < fields.count; ++i) {
      const std::uint32_t item = fields.items[i];
      const Octet cx = Octet(table.x[item]) - ox, cy = Octet(table.y[item]) - oy, cz = Octet(table.z[item]) - oz;
      const Octet scale(table.scale[item]);
      const Octet middle = (cx * dx + cy * dy + cz * dz) * inverse_dd;
      const Octet px = cx - middle * dx, py = cy - middle * dy, pz = cz - middle * dz;
      const std::array<Octet, 3> along{scale * (px * px + py * py + pz * pz), scale * dd, middle};
      const Octet near = max(t0_, min(t1_, middle)) - middle;
      if (adds(kernel, along[0] + along[1] * near * near, table.amplitude[item])) {
        store_along(along, new_row(table.amplitude[item]));
      }
    }
  }

  template <class Shape, class Kernel>
  HWY_INLINE void add_shapes(const Kernel& kernel, const ListedFields& fields) {
    using Form = typename RayFormOf<Shape>::type;
    begin(fields, fields.count);
    const KernelConstants& constants = fields.group.kernel;
    for (std::uint32_t i = 0; i < fields.count; ++i) {
      const std::uint32_t item = fields.items[i];
      const Shape shape = fields.table.shape<Shape>(fields.group, item);
      PacketRow& row =
          next_row(Form::along(shape, lines_in(fields, item)), Form::shape(shape), fields.table.amplitude[item]);
      const Octet v_least = load_lanes<Form>(row).bounds(t0_, t1_, constants.scale, constants.support).least;
      if (adds(kernel, v_least, row.amplitude[0])) ++rows_;
    }
  }

  template <class Kernel>
  HWY_INLINE void add_pieces(const Kernel& kernel, const ListedFields& fields) {
    begin(fields, 0);
    for (std::uint32_t i = 0; i < fields.count; ++i) add_pieces(kernel, fields.table, fields.group, fields.items[i]);
  }

  HWY_NOINLINE void add_curves(const ListedFields& fields) {
    begin(fields, fields.count);
    with_window(fields.group.kernel, [&](const auto& window) HWY_ATTR {
      with_curve_form(fields.group.skeleton, [&](auto type) HWY_ATTR {
        using Shape = typename decltype(type)::type;
        using Form = typename CurveFormOf<Shape>::type;
        for (std::uint32_t i = 0; i < fields.count; ++i) {
          const std::uint32_t item = fields.items[i];
          const Shape curve = fields.table.shape<Shape>(fields.group, item);
          const double unit = per_support(fields.group.kernel, curve), amplitude = fields.table.amplitude[item];
          PacketRow& row =
              next_row(Form::along(curve, unit, lines_in(fields, item)), Form::shape(curve, unit), amplitude);
          const Octet most = load_lanes<Form>(row).most(window, t0_, t1_);
          const OctetMask reaches = (most > Octet(0.0)) & lanes_;
          if (none(reaches)) continue;
          count(reaches);
          if (amplitude > 0) raise_peak(reaches, amplitude, most);
          ++rows_;
        }
      });
    });
  }

 private:
  using PacketRow = LaneRow<InLanes::rays>;
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  /// The rays in a component's own space.
  [[nodiscard]] HWY_INLINE Lines<Octet> lines_in(const ListedFields& fields, std::uint32_t item) const {
    Lines<Octet> lines;
    for (std::size_t i = 0; i < 3; ++i) {
      lines.o[i] = load(rays_.origin[i]);
      lines.d[i] = load(rays_.direction[i]);
    }
    if (!fields.group.is_mapped) return lines;
    const scene::Matrix& m = fields.table.blob_from_component(fields.group, item).inverse;
    Lines<Octet> mapped;
    for (int i = 0; i < 3; ++i) {
      const Octet x(m[0][i]), y(m[1][i]), z(m[2][i]);
      mapped.o[i] = lines.o[0] * x + lines.o[1] * y + lines.o[2] * z + Octet(m[3][i]);
      mapped.d[i] = lines.d[0] * x + lines.d[1] * y + lines.d[2] * z;
    }
    return mapped;
  }

  template <class Kernel>
  void add_pieces(const Kernel& kernel, const ComponentTable& table, const FieldGroup& group, std::uint32_t item) {
    m_.reserve(rows_ + kMostPieces);
    const double support = group.kernel.support, scale = ComponentTable::v_scale(group),
                 amplitude = table.amplitude[item];
    const std::uint32_t in_use = bits(lanes_), first = rows_;
    for (std::size_t lane = 0; lane < kPacket; ++lane) {
      if ((in_use >> lane & 1) == 0) continue;
      Vec3 origin = rays_.origin_of(lane), direction = rays_.direction_of(lane);
      if (group.is_mapped) {
        const scene::Transform& map = table.blob_from_component(group, item);
        origin = map.inverse_point(origin);
        direction = map.inverse_vector(direction);
      }
      std::uint32_t next = first;
      const auto emit = [&](const QuadraticPiece& piece) {
        const double v0 = scale * piece.q0, kappa = scale * piece.kappa;
        const double from = std::max(rays_.t0[lane], piece.begin), to = std::min(rays_.t1[lane], piece.end);
        if (!(from <= to)) return;
        const double near = std::clamp(piece.middle, from, to) - piece.middle;
        if (!(v0 + kappa * near * near < support)) return;
        if (next == rows_) clear(new_row(amplitude), 2 * support);
        PacketRow& row = m_.rows[next++];
        const double columns[] = {v0, kappa, piece.middle, piece.begin, piece.end};
        for (std::size_t c = 0; c < std::size(columns); ++c) row.along[c][lane] = columns[c];
      };
      table.with_skeleton(group, item, [&](const auto& shape) {
        using Shape = std::decay_t<decltype(shape)>;
        if constexpr (HasPieces<Shape>) shape.along(origin, direction, emit);
      });
    }
    for (std::uint32_t i = first; i < rows_; ++i) {
      const QuadraticLanes lanes = load_lanes<QuadraticLanes>(m_.rows[i]);
      const HeldPart part = held_part(borders_of(m_.rows[i]), t0_, t1_);
      const Octet near = max(Octet(0.0), max(part.from - lanes.middle, lanes.middle - part.to));
      adds(kernel, lanes.v0 + lanes.kappa * near * near, amplitude);
    }
  }
  /// Fills a row with pieces on which v = `beyond`, a value beyond the support.
  static HWY_INLINE void clear(PacketRow& row, double beyond) {
    const Octet zero(0.0);
    store_along(std::array{Octet(beyond), zero, zero, Octet(-kInfinity), Octet(kInfinity)}, row);
  }

  // ---- Rows
  // -----------------------------------------------------------------------------------------------------------

  /// True if the field reaches the stretch of any ray; `v_least` is the least v on each stretch. Adds the field to the
  /// counts and peaks of the rays that it reaches.
  template <class Kernel>
  HWY_INLINE bool adds(const Kernel& kernel, const Octet& v_least, double amplitude) {
    const OctetMask reaches = (v_least < kernel.support()) & lanes_;
    if (none(reaches)) return false;
    count(reaches);
    if (amplitude > 0) raise_peak(reaches, amplitude, kernel.value(v_least));
    return true;
  }
  HWY_INLINE void count(const OctetMask& reaches) { sums_.field_count = sums_.field_count + keep(reaches, Octet(1.0)); }
  HWY_INLINE void raise_peak(const OctetMask& reaches, double amplitude, const Octet& most) {
    sums_.peak = sums_.peak + keep(reaches, Octet(amplitude) * most);
  }

  /// Reserves memory for the rows of a group.
  void begin(const ListedFields& fields, std::uint32_t rows) {
    sums_.exponent = std::max(sums_.exponent, fields.group.kernel.support);
    m_.reserve(std::size_t{rows_} + rows);
  }
  template <std::size_t kCount>
  static HWY_INLINE void store_along(const std::array<Octet, kCount>& along, PacketRow& row) {
    for (std::size_t i = 0; i < kCount; ++i) store(along[i], row.along[i]);
  }
  /// Fills in the row after those in use, which the caller may keep by ++rows_.
  template <std::size_t kAlong, std::size_t kShape>
  HWY_INLINE PacketRow& next_row(const std::array<Octet, kAlong>& along, const std::array<double, kShape>& shape,
                                 double amplitude) {
    PacketRow& row = m_.rows[rows_];
    store_along(along, row);
    for (std::size_t i = 0; i < kShape; ++i) row.shape[i][0] = shape[i];
    row.amplitude[0] = amplitude;
    return row;
  }
  PacketRow& new_row(double amplitude) {
    PacketRow& row = m_.rows[rows_++];
    row.amplitude[0] = amplitude;
    return row;
  }

  PacketMemory& m_;
  const RayPacket& rays_;
  OctetMask lanes_;
  Octet t0_, t1_;
  Sums sums_;
  std::uint32_t rows_ = 0;  ///< number of rows in use
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
