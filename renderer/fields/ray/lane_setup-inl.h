// Lays out the fields of a cell's list side by side for one stretch of a ray, and drops those that cannot reach it.
//
// For a mapped component the ray is transformed, but its direction is not normalised again, so that t keeps its meaning
// and no bound needs scaling. Squared distances come from perpendicular vectors, never from |oc|² − (oc·D)², which
// cancels far from the origin. In most cells a ray meets no surface, so most of the time is spent here; therefore the
// same pass computes an upper bound of the sum.
#if defined(ISL_RENDERER_FIELDS_RAY_LANE_SETUP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_RAY_LANE_SETUP_INL_H_
#undef ISL_RENDERER_FIELDS_RAY_LANE_SETUP_INL_H_
#else
#define ISL_RENDERER_FIELDS_RAY_LANE_SETUP_INL_H_
#endif

#include "renderer/fields/convolutions/curve_field.h"
#include "renderer/fields/ray/gather-inl.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class LaneSetup {
 public:
  using Number = double;
  using Sums = SetupSums<std::uint32_t, double>;

  HWY_INLINE LaneSetup(LaneMemory& memory, const Vec3& origin, const Vec3& direction, double t0, double t1)
      : m_(memory), origin_(origin), direction_(direction), t0_(t0), t1_(t1) {}

  /// `items` ascend. The seven entries after them must be readable and valid component numbers too (Grid::kListTail).
  [[nodiscard]] HWY_INLINE Sums gather_list(const ComponentTable& table, const std::uint32_t* items,
                                            std::uint32_t count) {
    // A run ends with a row that is not full, and a list cannot change group more often than it has entries.
    m_.reserve(kMostPieces * count / kOctet + count + 1);
    gather_fields(*this, m_, table, items, count);
    return sums_;
  }
  [[nodiscard]] std::uint32_t rows() const { return rows_; }

  /// The sum over all lanes: they belong to one ray.
  [[nodiscard]] static HWY_INLINE double total(const Octet& x) { return sum(x); }

  template <class Kernel>
  HWY_INLINE void add_points(const Kernel& kernel, const ListedFields& fields) {
    sums_.exponent = std::max(sums_.exponent, fields.group.kernel.support);
    const Octet ox(origin_.x), oy(origin_.y), oz(origin_.z), dx(direction_.x), dy(direction_.y), dz(direction_.z);
    const double dd = direction_.length2();
    const Octet inverse_dd(1 / dd), from(t0_), to(t1_), zero(0.0), per_radius(1 / std::sqrt(fields.group.kernel.scale));
    Octet peaks(0.0), moved(0.0);
    for (std::uint32_t i = 0; i < fields.count; i += kOctet) {
      const std::uint32_t* const index = fields.items + i;
      const OctetMask listed = first_lanes(std::min<std::uint32_t>(kOctet, fields.count - i));
      const Octet cx = gather(fields.table.x.data(), index) - ox;
      const Octet cy = gather(fields.table.y.data(), index) - oy;
      const Octet cz = gather(fields.table.z.data(), index) - oz;
      const Octet scale = gather(fields.table.scale.data(), index);
      const Octet middle = (cx * dx + cy * dy + cz * dz) * inverse_dd;
      const Octet px = cx - middle * dx, py = cy - middle * dy, pz = cz - middle * dz;
      const Octet v0 = scale * (px * px + py * py + pz * pz);
      const Octet kappa = scale * Octet(dd);
      const Octet near = max(from, min(to, middle)) - middle;
      const Octet v_least = v0 + kappa * near * near;
      const OctetMask reaches = (v_least < kernel.support()) & listed;
      if (none(reaches)) continue;
      const Octet amplitude = gather(fields.table.amplitude.data(), index);
      peaks = peaks + keep(reaches, max(amplitude, zero) * most_of(kernel, v_least));
      // Lanes that do not reach the stretch are kept: they add nothing, since v is beyond the support all along it. (To
      // compact the others costs more than it saves, since lists are short.) Lanes past the list's end are put out of
      // reach.
      LaneRow& row = m_.rows[rows_++];
      store(select(listed, v0, kernel.support() + kernel.support()), row.along[0]);
      store(keep(listed, kappa), row.along[1]);
      store(middle, row.along[2]);
      store(amplitude, row.amplitude);
      const Octet size = sqrt(v0 + kappa * middle * middle);
      store(keep(listed, spread_of(size * per_radius)), row.shape[kPointSpread]);
      if constexpr (NowhereSteep<Kernel>) moved = moved + keep(reaches, abs(amplitude) * size);
      sums_.field_count += static_cast<std::uint32_t>(std::popcount(bits(reaches)));
    }
    sums_.peak += sum(peaks);
    if constexpr (NowhereSteep<Kernel>) sums_.moved += Kernel::kSteepest * sum(moved);
  }

  template <class Kernel>
  HWY_INLINE void add_pieces(const Kernel& kernel, const ListedFields& fields) {
    const std::uint32_t first = rows_;
    lay_out_pieces(fields);
    Octet peaks(0.0);
    for (std::uint32_t i = first; i < rows_; ++i) {
      const auto lane = load_lanes<QuadraticLanes>(m_.rows[i]);
      const PieceBorders borders = borders_of(m_.rows[i]);
      add_peaks(kernel, least(lane, borders, held_part(borders, Octet(t0_), Octet(t1_))), lane.amplitude, peaks);
    }
    sums_.peak += sum(peaks);
  }

  template <class Shape, class Kernel>
  HWY_INLINE void add_shapes(const Kernel& kernel, const ListedFields& fields) {
    using Form = typename RayFormOf<Shape>::type;
    const std::uint32_t first = rows_;
    lay_out_shapes<Shape>(fields);
    const KernelConstants& constants = fields.group.kernel;
    Octet peaks(0.0);
    for (std::uint32_t i = first; i < rows_; ++i) {
      const auto lanes = load_placed<Form>(m_.rows[i]);
      const auto bounds = lanes.bounds(t0_, t1_, constants.scale, constants.support);
      add_peaks(kernel, lanes.least(bounds), lanes.amplitude, peaks);
    }
    sums_.peak += sum(peaks);
  }

  HWY_NOINLINE void add_curves(const ListedFields& fields) {
    sums_.exponent = std::max(sums_.exponent, fields.group.kernel.support);
    with_curve_form(fields.group.skeleton, [&](auto type) HWY_ATTR {
      using Shape = typename decltype(type)::type;
      using Form = typename CurveFormOf<Shape>::type;
      const std::uint32_t first = rows_;
      for_each_line<Shape>(fields, [&](const Shape& curve, double amplitude, const Vec3& origin, const Vec3& direction,
                                       Placement<double> place) HWY_ATTR {
        const double unit = per_support(fields.group.kernel, curve);
        place.size *= unit;
        put(Form::along(curve, unit, line(origin, direction)), Form::shape(curve, unit), amplitude, place);
      });
      fill_up<Form>();
      Octet peaks(0.0);
      with_window(fields.group.kernel, [&](const auto& window) HWY_ATTR {
        for (std::uint32_t i = first; i < rows_; ++i) {
          const auto lanes = load_placed<Form>(m_.rows[i]);
          peaks = peaks + max(lanes.amplitude, Octet(0.0)) * lanes.most(window, t0_, t1_);
        }
      });
      sums_.peak += sum(peaks);
    });
  }

 private:
  /// Adds each lane's greatest possible value on the stretch, if it is positive.
  template <class Kernel>
  static HWY_INLINE void add_peaks(const Kernel& kernel, const Octet& v_least, const Octet& amplitude, Octet& peaks) {
    peaks = peaks + keep(v_least < kernel.support(), max(amplitude, Octet(0.0)) * most_of(kernel, v_least));
  }

  /// Calls use(skeleton, amplitude, origin, direction, placement) for each field, with the ray in the component's own
  /// space, from `placement.start` on.
  template <class Shape, class Use>
  void for_each_line(const ListedFields& fields, const Use& use) {
    for (std::uint32_t i = 0; i < fields.count; ++i) {
      const std::uint32_t item = fields.items[i];
      const Shape shape = fields.table.shape<Shape>(fields.group, item);
      const PlacedLine line(fields, item, origin_, direction_);
      use(shape, fields.table.amplitude[item], line.origin, line.direction,
          Placement<double>{line.start, line.size + shape.extent()});
    }
    sums_.field_count += fields.count;
  }
  [[nodiscard]] static Lines<double> line(const Vec3& o, const Vec3& d) { return {{o.x, o.y, o.z}, {d.x, d.y, d.z}}; }

  // The functions below are out of line and compiled once for all kernels.

  HWY_NOINLINE void lay_out_pieces(const ListedFields& fields) {
    const double scale = ComponentTable::v_scale(fields.group), support = fields.group.kernel.support;
    sums_.exponent = std::max(sums_.exponent, support);
    with_skeleton_type(fields.group.skeleton, [&](auto type) {
      using Shape = typename decltype(type)::type;
      if constexpr (HasPieces<Shape>) {
        for_each_line<Shape>(fields, [&](const Shape& shape, double amplitude, const Vec3& origin,
                                         const Vec3& direction, const Placement<double>& place) {
          const double size = place.size * std::sqrt(scale) / shape.thickest();
          shape.along(origin, direction, [&](const QuadraticPiece& piece) {
            put_piece(piece, scale, amplitude, support, {place.start, size});
          });
        });
      }
    });
    while (lane_ != 0) put<5, 0>({2 * support, 0, 0, -kInfinity, kInfinity}, {}, 0, {0, 0});
  }
  /// Adds a piece of v = scale · q, unless it cannot reach the stretch.
  void put_piece(const QuadraticPiece& piece, double scale, double amplitude, double support,
                 const Placement<double>& place) {
    const double v0 = scale * piece.q0, kappa = scale * piece.kappa;
    const double middle = place.start + piece.middle, begin = place.start + piece.begin, end = place.start + piece.end;
    const double from = std::max(t0_, begin), to = std::min(t1_, end);
    if (!(from <= to)) return;
    const double near = std::clamp(middle, from, to) - middle;
    const double least = std::max(0.0, std::sqrt(v0 + kappa * near * near) - kPositionError * place.size);
    if (!(least * least < support)) return;
    put<5, 0>({v0, kappa, middle, begin, end}, {}, amplitude, place);
  }

  template <class Shape>
  HWY_NOINLINE void lay_out_shapes(const ListedFields& fields) {
    using Form = typename RayFormOf<Shape>::type;
    sums_.exponent = std::max(sums_.exponent, fields.group.kernel.support);
    for_each_line<Shape>(fields, [&](const Shape& shape, double amplitude, const Vec3& origin, const Vec3& direction,
                                     const Placement<double>& place) HWY_ATTR {
      put(Form::along(shape, line(origin, direction)), Form::shape(shape), amplitude, place);
    });
    fill_up<Form>();
  }

  /// Fills the next lane, and begins a new row after the last lane of one.
  template <std::size_t kAlong, std::size_t kShape>
  void put(const std::array<double, kAlong>& along, const std::array<double, kShape>& shape, double amplitude,
           const Placement<double>& place) {
    LaneRow& row = m_.rows[rows_];
    for (std::size_t i = 0; i < kAlong; ++i) row.along[i][lane_] = along[i];
    for (std::size_t i = 0; i < kShape; ++i) row.shape[i][lane_] = shape[i];
    row.amplitude[lane_] = amplitude;
    row.start[lane_] = place.start;
    row.size[lane_] = place.size;
    if (++lane_ < kOctet) return;
    lane_ = 0;
    ++rows_;
  }
  /// Fills the rest of the row with lanes that add nothing.
  template <class Form>
  void fill_up() {
    std::array<double, Form::kAlong> along;
    std::array<double, Form::kShape> shape;
    std::copy_n(Form::kOutOfReach.begin(), along.size(), along.begin());
    std::copy_n(Form::kOutOfReach.begin() + along.size(), shape.size(), shape.begin());
    while (lane_ != 0) put(along, shape, 0, {0, 0});
  }

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  LaneMemory& m_;
  const Vec3 &origin_, &direction_;
  double t0_, t1_;
  Sums sums_;
  std::uint32_t rows_ = 0;  ///< number of full rows
  std::size_t lane_ = 0;    ///< the next lane to fill in the row after them
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
