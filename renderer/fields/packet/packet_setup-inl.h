// The fields of a cell's list laid out for eight rays; what cannot reach the stretch of any of them is dropped: lane_setup-inl.h
// turned by a quarter. Of pieces the n-th along all the rays make one row, as the rays cut a skeleton in different orders.
#if defined(ISL_RENDERER_FIELDS_PACKET_PACKET_SETUP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_PACKET_PACKET_SETUP_INL_H_
#undef ISL_RENDERER_FIELDS_PACKET_PACKET_SETUP_INL_H_
#else
#define ISL_RENDERER_FIELDS_PACKET_PACKET_SETUP_INL_H_
#endif

#include "renderer/fields/component_table.h"
#include "renderer/fields/convolutions/curve_field.h"
#include "renderer/fields/packet/packet_rows-inl.h"
#include "renderer/fields/ray/about_axis-inl.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// What is known of the stretches once their fields are laid out.
struct PacketSums {
  Octet field_count;    ///< that reach each ray's stretch
  Octet peak;           ///< no value of the sum on it is greater, rounding apart
  double exponent = 0;  ///< the greatest v within any support

  HWY_INLINE PacketSums() : field_count(0.0), peak(0.0) {}
};

class PacketSetup {
 public:
  /// For the rays in these lanes.
  HWY_INLINE PacketSetup(PacketMemory& memory, const RayPacket& rays, const OctetMask& lanes)
      : m_(memory), rays_(rays), lanes_(lanes), t0_(load(rays.t0)), t1_(load(rays.t1)) {}

  [[nodiscard]] HWY_INLINE PacketSums gather_list(const ComponentTable& table, const std::uint32_t* items,
                                                  std::uint32_t count) {
    m_.runs.clear();
    std::uint32_t next = 0;
    while (next < count) {
      const FieldGroup& group = table.group_of(items[next]);
      std::uint32_t last = next + 1;
      while (last < count && items[last] < group.end) ++last;
      sums_.exponent = std::max(sums_.exponent, group.kernel.support);
      const std::uint32_t first = rows_;
      const PacketForm form = add_group(table, group, items + next, last - next);
      if (rows_ > first) m_.runs.push_back({&group.kernel, form, first, rows_});
      next = last;
    }
    return sums_;
  }

 private:
  /// A triangle's.
  static constexpr std::uint32_t kMostPieces = 10;
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  HWY_INLINE PacketForm add_group(const ComponentTable& table, const FieldGroup& group, const std::uint32_t* items,
                                  std::uint32_t count) {
    if (group.kernel.is_convolved) return add_curves(table, group, items, count);
    PacketForm form = PacketForm::pieces;
    with_kernel(group.kernel, [&](const auto& kernel) HWY_ATTR {
      if (group.skeleton == scene::Skeleton::point && !group.is_mapped) {
        form = PacketForm::points;
        add_points(kernel, table, items, count);
        return;
      }
      for (std::uint32_t i = 0; i < count; ++i) {
        if (group.skeleton == scene::Skeleton::cone) {
          form = PacketForm::cones;
          add_shape<Cone>(kernel, table, group, items[i]);
        } else if (group.skeleton == scene::Skeleton::circle) {
          form = PacketForm::circles;
          add_shape<Circle>(kernel, table, group, items[i]);
        } else {
          add_pieces(kernel, table, group, items[i]);
        }
      }
    });
    return form;
  }

  template <class Kernel>
  HWY_INLINE void add_points(const Kernel& kernel, const ComponentTable& table, const std::uint32_t* items,
                             std::uint32_t count) {
    reserve(count);
    const Octet ox = load(rays_.origin[0]), oy = load(rays_.origin[1]), oz = load(rays_.origin[2]);
    const Octet dx = load(rays_.direction[0]), dy = load(rays_.direction[1]), dz = load(rays_.direction[2]);
    const Octet dd = dx * dx + dy * dy + dz * dz, inverse_dd = Octet(1.0) / dd;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t item = items[i];
      const Octet cx = Octet(table.x[item]) - ox, cy = Octet(table.y[item]) - oy, cz = Octet(table.z[item]) - oz;
      const Octet scale(table.scale[item]);
      const Octet middle = (cx * dx + cy * dy + cz * dz) * inverse_dd;
      const Octet px = cx - middle * dx, py = cy - middle * dy, pz = cz - middle * dz;
      const QuadraticLanes lanes{scale * (px * px + py * py + pz * pz), scale * dd, middle, Octet(table.amplitude[item])};
      const Octet near = max(t0_, min(t1_, middle)) - middle;
      if (adds(kernel, lanes.v0 + lanes.kappa * near * near, table.amplitude[item])) {
        store_row(lanes, new_row(table.amplitude[item]));
      }
    }
  }

  /// The rays in a component's own space.
  [[nodiscard]] HWY_INLINE Lines<Octet> lines_in(const ComponentTable& table, const FieldGroup& group, std::uint32_t item) const {
    Lines<Octet> lines;
    for (std::size_t i = 0; i < 3; ++i) {
      lines.o[i] = load(rays_.origin[i]);
      lines.d[i] = load(rays_.direction[i]);
    }
    if (!group.is_mapped) return lines;
    const scene::Matrix& m = table.blob_from_component(group, item).inverse;
    Lines<Octet> mapped;
    for (int i = 0; i < 3; ++i) {
      const Octet x(m[0][i]), y(m[1][i]), z(m[2][i]);
      mapped.o[i] = lines.o[0] * x + lines.o[1] * y + lines.o[2] * z + Octet(m[3][i]);
      mapped.d[i] = lines.d[0] * x + lines.d[1] * y + lines.d[2] * z;
    }
    return mapped;
  }

  [[nodiscard]] static HWY_INLINE ConeLanes lanes_of(const Cone& cone, const Lines<Octet>& lines) {
    const AboutAxis<Octet> line = about_axis(cone.a, cone.axis, lines);
    return {line.x0,           line.dx,           line.n0,            line.n2,   line.middle,
            Octet(cone.radius), Octet(cone.slope), Octet(cone.length), Octet(0.0)};
  }
  [[nodiscard]] static HWY_INLINE CircleLanes lanes_of(const Circle& circle, const Lines<Octet>& lines) {
    const AboutAxis<Octet> line = about_axis(circle.centre, circle.axis, lines);
    return {line.x0,     line.dx,
            line.n0,     line.n2,
            line.middle, Octet(circle.ring_radius),
            Octet(1 / (circle.radius * circle.radius)), Octet(0.0)};
  }
  static void set_shape(const Cone& cone, PacketRow& row) {
    row.shape[0] = cone.radius;
    row.shape[1] = cone.slope;
    row.shape[2] = cone.length;
  }
  static void set_shape(const Circle& circle, PacketRow& row) {
    row.shape[0] = circle.ring_radius;
    row.shape[1] = 1 / (circle.radius * circle.radius);
  }

  template <class Shape, class Kernel>
  HWY_INLINE void add_shape(const Kernel& kernel, const ComponentTable& table, const FieldGroup& group,
                            std::uint32_t item) {
    reserve(1);
    const Shape shape = table.shape<Shape>(group, item);
    const auto lanes = lanes_of(shape, lines_in(table, group, item));
    const Octet v_least = lanes.bounds(t0_, t1_, group.kernel.scale, group.kernel.support).least;
    if (!adds(kernel, v_least, table.amplitude[item])) return;
    PacketRow& row = new_row(table.amplitude[item]);
    store_row(lanes, row);
    set_shape(shape, row);
  }

  template <class Kernel>
  void add_pieces(const Kernel& kernel, const ComponentTable& table, const FieldGroup& group, std::uint32_t item) {
    reserve(kMostPieces);
    const double support = group.kernel.support, scale = ComponentTable::v_scale(group), amplitude = table.amplitude[item];
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
        if constexpr (!std::is_same_v<Shape, Cone> && !std::is_same_v<Shape, Circle>) {
          shape.along(origin, direction, emit);
        }
      });
    }
    for (std::uint32_t i = first; i < rows_; ++i) {
      const QuadraticLanes lanes = quadratic_of(m_.rows[i]);
      const PieceBorders borders = borders_of(m_.rows[i]);
      const Octet from = max(t0_, borders.begin), to = min(t1_, borders.end);
      const Octet near = max(Octet(0.0), max(from - lanes.middle, lanes.middle - to));
      adds(kernel, lanes.v0 + lanes.kappa * near * near, amplitude);
    }
  }
  /// A row of pieces that are beyond their support.
  static HWY_INLINE void clear(PacketRow& row, double beyond) {
    const Octet zero(0.0);
    store_row(QuadraticLanes{Octet(beyond), zero, zero, zero}, row);
    store(Octet(-kInfinity), row.along[3]);
    store(Octet(kInfinity), row.along[4]);
  }

  // ---- Convolved curves ---------------------------------------------------------------------------------------------

  HWY_NOINLINE PacketForm add_curves(const ComponentTable& table, const FieldGroup& group, const std::uint32_t* items,
                                     std::uint32_t count) {
    const bool are_segments = group.skeleton == scene::Skeleton::segment;
    reserve(count);
    with_window(group.kernel, [&](const auto& window) HWY_ATTR {
      for (std::uint32_t i = 0; i < count; ++i) {
        const Lines<Octet> lines = lines_in(table, group, items[i]);
        const double amplitude = table.amplitude[items[i]];
        if (are_segments) {
          add_curve(window, table.shape<Segment>(group, items[i]), group.kernel, lines, amplitude);
        } else {
          add_curve(window, table.shape<Circle>(group, items[i]), group.kernel, lines, amplitude);
        }
      }
    });
    return are_segments ? PacketForm::segments : PacketForm::rings;
  }

  template <class Window, class Curve>
  HWY_INLINE void add_curve(const Window& window, const Curve& curve, const KernelConstants& kernel, const Lines<Octet>& lines,
                            double amplitude) {
    const double unit = per_support(kernel, curve);
    const auto lanes = curve_lanes(curve, unit, lines);
    const Octet most = lanes.most(window, t0_, t1_);
    const OctetMask reaches = (most > Octet(0.0)) & lanes_;
    if (none(reaches)) return;
    count(reaches);
    if (amplitude > 0) raise_peak(reaches, amplitude, most);
    PacketRow& row = new_row(amplitude);
    store_row(lanes, row);
    row.shape[0] = unit * length_of(curve);
  }
  [[nodiscard]] static double length_of(const Segment& segment) { return segment.length; }
  [[nodiscard]] static double length_of(const Circle& ring) { return ring.ring_radius; }

  [[nodiscard]] static HWY_INLINE SegmentLanes curve_lanes(const Segment& segment, double per_unit, const Lines<Octet>& lines) {
    const AboutAxis<Octet> from_a = about_axis(segment.a, segment.axis, lines);
    const AboutAxis<Octet> from_b = about_axis(segment.a + segment.axis * segment.length, segment.axis, lines);
    // From the nearer end: the farther one's distance would cost digits.
    const OctetMask nearer_a = abs(from_a.x0) < abs(from_b.x0);
    const Octet unit(per_unit), unit2 = unit * unit;
    return {from_a.x0 * unit,
            (Octet(0.0) - from_b.x0) * unit,
            select(nearer_a, from_a.dx, from_b.dx) * unit,
            select(nearer_a, from_a.n0, from_b.n0) * unit2,
            select(nearer_a, from_a.n2, from_b.n2) * unit2,
            select(nearer_a, from_a.middle, from_b.middle),
            Octet(segment.length) * unit,
            Octet(0.0)};
  }
  [[nodiscard]] static HWY_INLINE RingLanes curve_lanes(const Circle& ring, double per_unit, const Lines<Octet>& lines) {
    const AboutAxis<Octet> line = about_axis(ring.centre, ring.axis, lines);
    const Octet unit(per_unit), unit2 = unit * unit;
    return {line.x0 * unit, line.dx * unit, line.n0 * unit2, line.n2 * unit2, line.middle, Octet(ring.ring_radius) * unit, Octet(0.0)};
  }

  // ---- Rows -----------------------------------------------------------------------------------------------------------

  /// Whether the field reaches the stretch of any ray, coming no nearer than `v_least`. Counts it where it does.
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

  void reserve(std::uint32_t rows) {
    if (rows_ + rows > m_.rows.size()) m_.rows.resize(2 * std::size_t{rows_ + rows});
  }
  PacketRow& new_row(double amplitude) {
    PacketRow& row = m_.rows[rows_++];
    row.amplitude = amplitude;
    return row;
  }

  PacketMemory& m_;
  const RayPacket& rays_;
  OctetMask lanes_;
  Octet t0_, t1_;
  PacketSums sums_;
  std::uint32_t rows_ = 0;  ///< in use
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
