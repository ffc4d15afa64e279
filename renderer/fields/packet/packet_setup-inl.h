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
#include <cmath>
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
    // A field that reaches the stretch of a ray is no farther from where the ray starts than the stretch's end and the
    // radius of its support together. The root of the sum of squares is a bound for all eight rays.
    const double farthest = std::sqrt(sum(keep(lanes_, max(t0_ * t0_, t1_ * t1_) * dd)));
    const KernelConstants& constants = fields.group.kernel;
    const double per_radius = 1 / std::sqrt(constants.scale), beyond = std::sqrt(constants.support);
    double moved = 0;
    for (std::uint32_t i = 0; i < fields.count; ++i) {
      const std::uint32_t item = fields.items[i];
      const Octet cx = Octet(table.x[item]) - ox, cy = Octet(table.y[item]) - oy, cz = Octet(table.z[item]) - oz;
      const Octet scale(table.scale[item]);
      const Octet middle = (cx * dx + cy * dy + cz * dz) * inverse_dd;
      const Octet px = cx - middle * dx, py = cy - middle * dy, pz = cz - middle * dz;
      const std::array<Octet, 3> along{scale * (px * px + py * py + pz * pz), scale * dd, middle};
      const Octet near = max(t0_, min(t1_, middle)) - middle;
      if (!adds(kernel, along[0] + along[1] * near * near, table.amplitude[item])) continue;
      PacketRow& row = new_row(table.amplitude[item]);
      store_along(along, row);
      const double size = std::sqrt(table.scale[item]) * farthest + beyond;
      if constexpr (NowhereSteep<Kernel>) {
        moved += std::abs(table.amplitude[item]) * size;
      } else {
        row.shape[kPointSpread][0] = spread_of(size * per_radius);
      }
    }
    if constexpr (NowhereSteep<Kernel>) sums_.moved = sums_.moved + Octet(Kernel::kSteepest * moved);
  }

  template <class Shape, class Kernel>
  HWY_INLINE void add_shapes(const Kernel& kernel, const ListedFields& fields) {
    using Form = typename RayFormOf<Shape>::type;
    begin(fields, fields.count);
    const KernelConstants& constants = fields.group.kernel;
    for (std::uint32_t i = 0; i < fields.count; ++i) {
      const std::uint32_t item = fields.items[i];
      const Shape shape = fields.table.shape<Shape>(fields.group, item);
      const PlacedLines lines = lines_in(fields, item);
      const Placement<Octet> place{lines.start, lines.size + Octet(shape.extent())};
      PacketRow& row = next_row(Form::along(shape, lines), Form::shape(shape), fields.table.amplitude[item], place);
      const auto lanes = load_placed<Form>(row);
      const auto bounds = lanes.bounds(t0_, t1_, constants.scale, constants.support);
      if (adds(kernel, lanes.least(bounds), row.amplitude[0])) ++rows_;
    }
  }

  template <class Kernel>
  HWY_INLINE void add_pieces(const Kernel& kernel, const ListedFields& fields) {
    begin(fields, 0);
    for (std::uint32_t i = 0; i < fields.count; ++i) add_pieces(kernel, fields, fields.items[i]);
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
          const PlacedLines lines = lines_in(fields, item);
          const Octet size = Octet(unit) * (lines.size + Octet(curve.extent()));
          PacketRow& row =
              next_row(Form::along(curve, unit, lines), Form::shape(curve, unit), amplitude, {lines.start, size});
          const Octet most = load_placed<Form>(row).most(window, t0_, t1_);
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

  /// As PlacedLine, for eight rays.
  struct PlacedLines : Lines<Octet> {
    Octet start, size;
  };
  [[nodiscard]] HWY_INLINE PlacedLines lines_in(const ListedFields& fields, std::uint32_t item) const {
    const ComponentTable& table = fields.table;
    Octet o[3], d[3];
    for (std::size_t i = 0; i < 3; ++i) {
      o[i] = load(rays_.origin[i]);
      d[i] = load(rays_.direction[i]);
    }
    const Octet centre[3] = {Octet(table.x[item]), Octet(table.y[item]), Octet(table.z[item])};
    const scene::Transform* const map =
        fields.group.is_mapped ? &table.blob_from_component(fields.group, item) : nullptr;
    PlacedLines lines;
    for (int i = 0; i < 3; ++i) {
      lines.o[i] = map ? image(o, map->inverse, i) + Octet(map->inverse[3][i]) : o[i];
      lines.d[i] = map ? image(d, map->inverse, i) : d[i];
    }
    Octet along(0.0), length2(0.0);
    for (int i = 0; i < 3; ++i) {
      along = along + (centre[i] - lines.o[i]) * lines.d[i];
      length2 = length2 + lines.d[i] * lines.d[i];
    }
    const Octet t = along / length2;
    lines.start = keep(abs(t) < Octet(kInfinity), t);
    for (std::size_t i = 0; i < 3; ++i) o[i] = o[i] + d[i] * lines.start;
    Octet distance2(0.0), terms(0.0);
    for (int i = 0; i < 3; ++i) {
      lines.o[i] = map ? image(o, map->inverse, i) + Octet(map->inverse[3][i]) : o[i];
      const Octet away = lines.o[i] - centre[i];
      distance2 = distance2 + away * away;
      if (!map) continue;
      Octet sum(std::abs(map->inverse[3][i]));
      for (int j = 0; j < 3; ++j) sum = sum + abs(o[j] * Octet(map->inverse[j][i]));
      terms = max(terms, sum);
    }
    lines.size = sqrt(distance2) + terms;
    return lines;
  }
  /// Coordinate i of the image of a vector.
  [[nodiscard]] static HWY_INLINE Octet image(const Octet (&v)[3], const scene::Matrix& m, int i) {
    return v[0] * Octet(m[0][i]) + v[1] * Octet(m[1][i]) + v[2] * Octet(m[2][i]);
  }

  template <class Kernel>
  void add_pieces(const Kernel& kernel, const ListedFields& fields, std::uint32_t item) {
    const ComponentTable& table = fields.table;
    const FieldGroup& group = fields.group;
    m_.reserve(rows_ + kMostPieces);
    const double support = group.kernel.support, scale = ComponentTable::v_scale(group),
                 amplitude = table.amplitude[item];
    const std::uint32_t in_use = bits(lanes_), first = rows_;
    for (std::size_t lane = 0; lane < kPacket; ++lane) {
      if ((in_use >> lane & 1) == 0) continue;
      const PlacedLine line(fields, item, rays_.origin_of(lane), rays_.direction_of(lane));
      double size = 0;
      std::uint32_t next = first;
      const auto emit = [&](const QuadraticPiece& piece) {
        const double v0 = scale * piece.q0, kappa = scale * piece.kappa;
        const double middle = line.start + piece.middle, begin = line.start + piece.begin, end = line.start + piece.end;
        const double from = std::max(rays_.t0[lane], begin), to = std::min(rays_.t1[lane], end);
        if (!(from <= to)) return;
        const double near = std::clamp(middle, from, to) - middle;
        const double least = std::max(0.0, std::sqrt(v0 + kappa * near * near) - kPositionError * size);
        if (!(least * least < support)) return;
        if (next == rows_) clear(new_row(amplitude), 2 * support);
        PacketRow& row = m_.rows[next++];
        const double columns[] = {v0, kappa, middle, begin, end};
        for (std::size_t c = 0; c < std::size(columns); ++c) row.along[c][lane] = columns[c];
        row.size[lane] = size;
      };
      table.with_skeleton(group, item, [&](const auto& shape) {
        using Shape = std::decay_t<decltype(shape)>;
        size = (line.size + shape.extent()) * std::sqrt(scale) / shape.thickest();
        if constexpr (HasPieces<Shape>) shape.along(line.origin, line.direction, emit);
      });
    }
    for (std::uint32_t i = first; i < rows_; ++i) {
      const QuadraticLanes lanes = load_lanes<QuadraticLanes>(m_.rows[i]);
      const PieceBorders borders = borders_of(m_.rows[i]);
      adds(kernel, least(lanes, borders, held_part(borders, t0_, t1_)), amplitude);
    }
  }
  /// Fills a row with pieces on which v = `beyond`, a value beyond the support.
  static HWY_INLINE void clear(PacketRow& row, double beyond) {
    const Octet zero(0.0);
    store_along(std::array{Octet(beyond), zero, zero, Octet(-kInfinity), Octet(kInfinity)}, row);
    store(zero, row.size);
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
                                 double amplitude, const Placement<Octet>& place) {
    PacketRow& row = m_.rows[rows_];
    store_along(along, row);
    for (std::size_t i = 0; i < kShape; ++i) row.shape[i][0] = shape[i];
    row.amplitude[0] = amplitude;
    store(place.start, row.start);
    store(place.size, row.size);
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
