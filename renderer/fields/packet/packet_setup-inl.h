// Lays out the fields of a cell's list for eight rays, one row for each field or for each of its pieces, and drops
// those that cannot reach the stretch of any of the rays.
#if defined(ISL_RENDERER_FIELDS_PACKET_PACKET_SETUP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_PACKET_PACKET_SETUP_INL_H_
#undef ISL_RENDERER_FIELDS_PACKET_PACKET_SETUP_INL_H_
#else
#define ISL_RENDERER_FIELDS_PACKET_PACKET_SETUP_INL_H_
#endif

#include "renderer/fields/convolutions/curve_field.h"
#include "renderer/fields/packet/near_fields-inl.h"
#include "renderer/fields/packet/packet_sums-inl.h"
#include "renderer/fields/packet/placed_lines-inl.h"
#include "renderer/fields/packet/ray_packet.h"
#include "renderer/fields/ray/gather-inl.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <span>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class PacketSetup {
 public:
  using Number = Octet;
  using Sums = PacketSums;

  /// Sets up for the rays in these lanes only.
  HWY_INLINE PacketSetup(LaneMemory& memory, const RayPacket& rays, const OctetMask& lanes)
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
    std::array<std::uint32_t, kMostTested> kept;
    std::span<const std::uint32_t> items(fields.items, fields.count);
    if (items.size() >= kLeastTested && items.size() <= kMostTested)
      items = {kept.data(), near_fields(table.supports, rays_, lanes_, items, kept.data())};
    const Octet ox = load(rays_.origin[0]), oy = load(rays_.origin[1]), oz = load(rays_.origin[2]);
    const Octet dx = load(rays_.direction[0]), dy = load(rays_.direction[1]), dz = load(rays_.direction[2]);
    const Octet dd = load(rays_.length2), inverse_dd = load(rays_.per_length2), one(1.0);
    // A field that reaches the stretch of a ray is no farther from where the ray starts than the stretch's end and the
    // radius of its support together. The root of the sum of squares is a bound for all eight rays.
    const auto farthest = [&]() HWY_ATTR { return std::sqrt(sum(keep(lanes_, max(t0_ * t0_, t1_ * t1_) * dd))); };
    const KernelConstants& constants = fields.group.kernel;
    const double beyond = std::sqrt(constants.support);
    [[maybe_unused]] double reach = 0, per_radius = 0;
    if constexpr (!NowhereSteep<Kernel>) {
      reach = farthest();
      per_radius = 1 / std::sqrt(constants.scale);
    }
    // Members would be written and read back for every field, because rows may lie where they do for all that the
    // compiler knows.
    const OctetMask lanes = lanes_;
    const Octet t0 = t0_, t1 = t1_;
    const Octet infinity(kInfinity), nowhere(-kInfinity);
    Octet count(0.0), peak(0.0), rising_until = infinity, falling_from = nowhere;
    LaneRow* row = m_.rows.data() + rows_;
    double strength = 0, per_distance = 0;  // of the fields that are added: Σ|a| and Σ|a|√scale
    for (const std::uint32_t item : items) {
      const Octet cx = Octet(table.x[item]) - ox, cy = Octet(table.y[item]) - oy, cz = Octet(table.z[item]) - oz;
      const Octet scale(table.scale[item]);
      const Octet middle = (cx * dx + cy * dy + cz * dz) * inverse_dd;
      const Octet px = cx - middle * dx, py = cy - middle * dy, pz = cz - middle * dz;
      const std::array<Octet, 3> along{scale * (px * px + py * py + pz * pz), scale * dd, middle};
      const Octet near = max(t0, min(t1, middle)) - middle, v_least = along[0] + along[1] * near * near;
      const OctetMask reaches = (v_least < kernel.support()) & lanes;
      if (none(reaches)) continue;
      const double amplitude = table.amplitude[item], root = std::sqrt(table.scale[item]);
      count = count + keep(reaches, one);
      if (amplitude > 0) {
        peak = peak + keep(reaches, Octet(amplitude) * most_of(kernel, v_least));
        rising_until = select(reaches, min(rising_until, middle), rising_until);
        falling_from = select(reaches, max(falling_from, middle), falling_from);
      } else {
        rising_until = nowhere;
        falling_from = infinity;
      }
      store(Octet(amplitude), row->amplitude);
      store_along(along, *row);
      if constexpr (NowhereSteep<Kernel>) {
        strength += std::abs(amplitude);
        per_distance += std::abs(amplitude) * root;
      } else {
        store(Octet(spread_of((root * reach + beyond) * per_radius)), row->shape[kPointSpread]);
      }
      ++row;
    }
    rows_ = static_cast<std::uint32_t>(row - m_.rows.data());
    sums_.field_count = sums_.field_count + count;
    sums_.peak = sums_.peak + peak;
    sums_.rising_until = min(sums_.rising_until, rising_until);
    sums_.falling_from = max(sums_.falling_from, falling_from);
    if constexpr (NowhereSteep<Kernel>) {
      // Without a field it may be 0·∞.
      if (strength > 0)
        sums_.moved = sums_.moved + Octet(Kernel::kSteepest * (per_distance * farthest() + strength * beyond));
    }
  }

  template <class Shape, class Kernel>
  HWY_INLINE void add_shapes(const Kernel& kernel, const ListedFields& fields) {
    using Form = typename RayFormOf<Shape>::type;
    know_no_trend();
    begin(fields, fields.count);
    const KernelConstants& constants = fields.group.kernel;
    for (std::uint32_t i = 0; i < fields.count; ++i) {
      const std::uint32_t item = fields.items[i];
      const Shape shape = fields.table.shape<Shape>(fields.group, item);
      const PlacedLines lines(rays_, fields, item);
      const Placement<Octet> place{lines.start, lines.size + Octet(shape.extent())};
      LaneRow& row = next_row(Form::along(shape, lines), Form::shape(shape), fields.table.amplitude[item], place);
      const auto lanes = load_placed<Form>(row);
      const auto bounds = lanes.bounds(t0_, t1_, constants.scale, constants.support);
      if (adds(kernel, lanes.least(bounds), row.amplitude[0])) ++rows_;
    }
  }

  template <class Kernel>
  HWY_INLINE void add_pieces(const Kernel& kernel, const ListedFields& fields) {
    begin(fields, 0);
    for (std::uint32_t i = 0; i < fields.count; ++i) {
      const std::uint32_t first = rows_;
      lay_out_pieces(fields, fields.items[i]);
      for (std::uint32_t row = first; row < rows_; ++row) {
        const QuadraticLanes lanes = load_lanes<QuadraticLanes>(m_.rows[row]);
        const PieceBorders borders = borders_of(m_.rows[row]);
        const Octet v_least = least(lanes, borders, held_part(borders, t0_, t1_));
        const OctetMask reaches = (v_least < kernel.support()) & lanes_;
        if (none(reaches)) continue;
        count(reaches);
        const double amplitude = m_.rows[row].amplitude[0];
        if (amplitude > 0) {
          raise_peak(reaches, amplitude, most_of(kernel, v_least));
          const Octet infinity(kInfinity), nowhere(-kInfinity);
          const Octet falls_from = select(lanes.middle >= borders.end, infinity, max(borders.begin, lanes.middle));
          const Octet rises_until = select(lanes.middle <= borders.begin, nowhere, min(borders.end, lanes.middle));
          sums_.rising_until = select(reaches, min(sums_.rising_until, falls_from), sums_.rising_until);
          sums_.falling_from = select(reaches, max(sums_.falling_from, rises_until), sums_.falling_from);
        } else {
          know_no_trend();
        }
      }
    }
  }

  HWY_NOINLINE void add_curves(const ListedFields& fields) {
    know_no_trend();
    begin(fields, fields.count);
    with_window(fields.group.kernel, [&](const auto& window) HWY_ATTR {
      with_curve_form(fields.group.skeleton, [&](auto type) HWY_ATTR {
        using Shape = typename decltype(type)::type;
        using Form = typename CurveFormOf<Shape>::type;
        for (std::uint32_t i = 0; i < fields.count; ++i) {
          const std::uint32_t item = fields.items[i];
          const Shape curve = fields.table.shape<Shape>(fields.group, item);
          const double unit = per_support(fields.group.kernel, curve), amplitude = fields.table.amplitude[item];
          const PlacedLines lines(rays_, fields, item);
          const Octet size = Octet(unit) * (lines.size + Octet(curve.extent()));
          LaneRow& row =
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
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  // ---- Pieces
  // ---------------------------------------------------------------------------------------------------------

  /// A component with pieces, and the rays in its own space.
  struct InPieces {
    double scale, support, amplitude;
    double support_root;  ///< √support
    PlacedLines lines;
    Octet size;       ///< as in PieceBorders
    OctetMask meets;  ///< the rays that may reach it
  };

  // It is out of line and compiled once for all kernels.
  HWY_NOINLINE void lay_out_pieces(const ListedFields& fields, std::uint32_t item) {
    with_skeleton_type(fields.group.skeleton, [&](auto type) HWY_ATTR {
      using Shape = typename decltype(type)::type;
      if constexpr (HasPieces<Shape>) lay_out_pieces(fields, item, fields.table.shape<Shape>(fields.group, item));
    });
  }
  template <class Shape>
  HWY_INLINE void lay_out_pieces(const ListedFields& fields, std::uint32_t item, const Shape& shape) {
    const FieldGroup& group = fields.group;
    const double scale = ComponentTable::v_scale(group);
    const PlacedLines lines(rays_, fields, item);
    OctetMask meets = lanes_;
    if constexpr (!Endless<Shape>)
      meets = lanes_ & lines.near_ball(shape, ComponentTable::support_root(group), t0_, t1_);
    if (none(meets)) return;
    const Octet size = (lines.size + Octet(shape.extent())) * Octet(std::sqrt(scale) / shape.thickest());
    m_.reserve(rows_ + kMostPieces);
    const double support = group.kernel.support;
    const InPieces component{scale, support, fields.table.amplitude[item], std::sqrt(support), lines, size, meets};
    using Pieces = typename PiecesAlong<Shape>::type;
    if constexpr (std::is_void_v<Pieces>) {
      put_ray_by_ray(component, shape);
    } else {
      Pieces::along(shape, lines, [&](const Octet& begin, const Octet& end, const auto& quadratic) HWY_ATTR {
        put(component, begin, end, quadratic);
      });
    }
  }
  /// Makes a row of a piece, unless it cannot reach the stretch of any ray.
  template <class Quadratic>
  HWY_INLINE void put(const InPieces& c, const Octet& from_start, const Octet& to_start, const Quadratic& quadratic) {
    const Octet zero(0.0), scale(c.scale), support(c.support), infinity(kInfinity);
    const Octet begin = c.lines.start + from_start, end = c.lines.start + to_start;
    const Octet from = max(t0_, begin), to = min(t1_, end);
    const OctetMask is_there = c.meets & (from <= to);
    if (none(is_there)) return;
    const OctetQuadratic piece = quadratic();
    const Octet v0 = scale * piece.q0, kappa = scale * piece.kappa, middle = c.lines.start + piece.middle;
    const Octet near = max(zero, max(from - middle, middle - to));
    const Octet farthest = Octet(c.support_root) + Octet(kPositionError) * c.size;
    const OctetMask holds = and_not(v0 + kappa * near * near >= farthest * farthest, is_there);
    if (none(holds)) return;
    LaneRow& row = new_row(c.amplitude);
    store_along(std::array{select(holds, v0, support + support), keep(holds, kappa), keep(holds, middle),
                           select(holds, begin, zero - infinity), select(holds, end, infinity)},
                row);
    store(keep(holds, c.size), row.size);
  }
  /// Makes rows of the n-th piece along each ray, without those that cannot reach its stretch. These may be different
  /// pieces of the skeleton, since the rays cut it in different orders.
  template <class Shape>
  HWY_INLINE void put_ray_by_ray(const InPieces& c, const Shape& shape) {
    alignas(64) double o[3][kPacket], d[3][kPacket], start[kPacket], size[kPacket];
    for (std::size_t i = 0; i < 3; ++i) {
      store(c.lines.o[i], o[i]);
      store(c.lines.d[i], d[i]);
    }
    store(c.lines.start, start);
    store(c.size, size);
    const std::uint32_t first = rows_;
    for (std::uint32_t left = bits(c.meets); left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      std::uint32_t next = first;
      const auto emit = [&](const QuadraticPiece& piece) {
        const double v0 = c.scale * piece.q0, kappa = c.scale * piece.kappa;
        const double middle = start[lane] + piece.middle, begin = start[lane] + piece.begin,
                     end = start[lane] + piece.end;
        const double from = std::max(rays_.t0[lane], begin), to = std::min(rays_.t1[lane], end);
        if (!(from <= to)) return;
        const double near = std::clamp(middle, from, to) - middle;
        const double least = std::max(0.0, std::sqrt(v0 + kappa * near * near) - kPositionError * size[lane]);
        if (!(least * least < c.support)) return;
        if (next == rows_) clear(new_row(c.amplitude), 2 * c.support);
        LaneRow& row = m_.rows[next++];
        const double columns[] = {v0, kappa, middle, begin, end};
        for (std::size_t i = 0; i < std::size(columns); ++i) row.along[i][lane] = columns[i];
        row.size[lane] = size[lane];
      };
      shape.along({o[0][lane], o[1][lane], o[2][lane]}, {d[0][lane], d[1][lane], d[2][lane]}, emit);
    }
  }
  /// Fills a row with pieces on which v = `beyond`, a value beyond the support.
  static HWY_INLINE void clear(LaneRow& row, double beyond) {
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
    if (amplitude > 0) raise_peak(reaches, amplitude, most_of(kernel, v_least));
    return true;
  }
  HWY_INLINE void count(const OctetMask& reaches) { sums_.field_count = sums_.field_count + keep(reaches, Octet(1.0)); }
  HWY_INLINE void raise_peak(const OctetMask& reaches, double amplitude, const Octet& most) {
    sums_.peak = sums_.peak + keep(reaches, Octet(amplitude) * most);
  }

  HWY_INLINE void know_no_trend() {
    sums_.rising_until = Octet(-kInfinity);
    sums_.falling_from = Octet(kInfinity);
  }

  /// Reserves memory for the rows of a group.
  void begin(const ListedFields& fields, std::uint32_t rows) {
    sums_.exponent = std::max(sums_.exponent, fields.group.kernel.support);
    m_.reserve(std::size_t{rows_} + rows);
  }
  template <std::size_t kCount>
  static HWY_INLINE void store_along(const std::array<Octet, kCount>& along, LaneRow& row) {
    for (std::size_t i = 0; i < kCount; ++i) store(along[i], row.along[i]);
  }
  /// Fills in the row after those in use, which the caller may keep by ++rows_.
  template <std::size_t kAlong, std::size_t kShape>
  HWY_INLINE LaneRow& next_row(const std::array<Octet, kAlong>& along, const std::array<double, kShape>& shape,
                               double amplitude, const Placement<Octet>& place) {
    LaneRow& row = m_.rows[rows_];
    store_along(along, row);
    for (std::size_t i = 0; i < kShape; ++i) store(Octet(shape[i]), row.shape[i]);
    store(Octet(amplitude), row.amplitude);
    store(place.start, row.start);
    store(place.size, row.size);
    return row;
  }
  LaneRow& new_row(double amplitude) {
    LaneRow& row = m_.rows[rows_++];
    store(Octet(amplitude), row.amplitude);
    return row;
  }

  LaneMemory& m_;
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
