// The fields of a cell's list, laid out side by side for one stretch of a ray; what cannot reach the stretch is
// dropped.
//
// An affine component is met by a transformed ray whose direction is not normalised again, so that t means the same and
// no bound needs scaling. Squared distances come from perpendicular vectors, never from |oc|² − (oc·D)², which cancels
// far from the origin. Most cells that a ray meets hold no surface on its way, so this is where most of the time goes:
// the greatest value that the sum can have comes out of the same pass.
#if defined(ISL_RENDERER_FIELDS_RAY_LANE_SETUP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_RAY_LANE_SETUP_INL_H_
#undef ISL_RENDERER_FIELDS_RAY_LANE_SETUP_INL_H_
#else
#define ISL_RENDERER_FIELDS_RAY_LANE_SETUP_INL_H_
#endif

#include "renderer/fields/component_table.h"
#include "renderer/fields/convolutions/curve_field.h"
#include "renderer/fields/kernels/kernels-inl.h"
#include "renderer/fields/ray/about_axis-inl.h"
#include "renderer/fields/ray/lane_columns-inl.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// What is known of a stretch once its fields are laid out.
struct LaneSums {
  std::uint32_t field_count = 0;
  double peak = 0;      ///< no value of the sum on the stretch is greater, rounding apart
  double exponent = 0;  ///< the greatest v within any support
};

class LaneSetup {
 public:
  explicit LaneSetup(LaneMemory& memory) : m_(memory) {}

  /// `items` ascend, and the seven entries behind them can be read and name components too (Grid::kListTail).
  [[nodiscard]] HWY_INLINE LaneSums gather_list(const ComponentTable& table, const std::uint32_t* items,
                                                std::uint32_t count, const Vec3& origin, const Vec3& direction,
                                                double t0, double t1) {
    m_.runs.clear();
    m_.reserve_lanes(count);
    std::uint32_t next = 0;
    while (next < count) {
      const FieldGroup& group = table.group_of(items[next]);
      std::uint32_t last = next + 1;
      if (items[count - 1] < group.end) {
        last = count;
      } else {
        while (last < count && items[last] < group.end) ++last;
      }
      first_ = {quadratics_, cones_, circles_, segments_, rings_};
      if (group.kernel.is_convolved) {
        add_curves(table, group, items + next, last - next, origin, direction, t0, t1);
      } else {
        with_kernel(group.kernel, [&](const auto& kernel) HWY_ATTR {
          add_group(kernel, table, group, items + next, last - next, origin, direction, t0, t1);
        });
      }
      close_run(group);
      next = last;
    }
    return sums_;
  }

 private:
  template <class Kernel>
  HWY_INLINE void add_group(const Kernel& kernel, const ComponentTable& table, const FieldGroup& group,
                            const std::uint32_t* items, std::uint32_t count, const Vec3& origin, const Vec3& direction,
                            double t0, double t1) {
    sums_.exponent = std::max(sums_.exponent, group.kernel.support);
    if (group.skeleton == scene::Skeleton::point && !group.is_mapped)
      return add_points(kernel, table, items, count, origin, direction, t0, t1);
    add_shapes(table, group, items, count, origin, direction, t0, t1);
    pad(group.kernel.support);
    sum_up(kernel, group, t0, t1);
  }

  void add_curves(const ComponentTable& table, const FieldGroup& group, const std::uint32_t* items,
                  std::uint32_t count, const Vec3& origin, const Vec3& direction, double t0, double t1) {
    sums_.exponent = std::max(sums_.exponent, group.kernel.support);
    add_shapes(table, group, items, count, origin, direction, t0, t1);
    pad_curves();
    const Octet zero(0.0);
    Octet peaks(0.0);
    with_window(group.kernel, [&](const auto& window) HWY_ATTR {
      for (std::uint32_t i = first_.segments; i < segments_; i += kOctet) {
        const SegmentLanes lanes = load_segment(m_, i);
        peaks = peaks + max(lanes.amplitude, zero) * lanes.most(window, t0, t1);
      }
      for (std::uint32_t i = first_.rings; i < rings_; i += kOctet) {
        const RingLanes lanes = load_ring(m_, i);
        peaks = peaks + max(lanes.amplitude, zero) * lanes.most(window, t0, t1);
      }
    });
    sums_.peak += sum(peaks);
  }

  void add_shapes(const ComponentTable& table, const FieldGroup& group, const std::uint32_t* items,
                  std::uint32_t count, const Vec3& origin, const Vec3& direction, double t0, double t1) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t item = items[i];
      if (group.is_mapped) {
        const scene::Transform& map = table.blob_from_component(group, item);
        add_shape(table, group, item, map.inverse_point(origin), map.inverse_vector(direction), t0, t1);
      } else {
        add_shape(table, group, item, origin, direction, t0, t1);
      }
    }
    sums_.field_count += count;
  }

  void add_shape(const ComponentTable& table, const FieldGroup& group, std::uint32_t item, const Vec3& origin,
                 const Vec3& direction, double t0, double t1) {
    const double amplitude = table.amplitude[item];
    table.with_skeleton(group, item, [&](const auto& shape) {
      using Shape = std::decay_t<decltype(shape)>;
      if constexpr (std::is_same_v<Shape, Segment> || std::is_same_v<Shape, Circle>) {
        if (group.kernel.is_convolved) return add_curve(shape, group.kernel, amplitude, origin, direction);
      }
      if constexpr (std::is_same_v<Shape, Cone>) {
        add_cone(shape, amplitude, origin, direction);
      } else if constexpr (std::is_same_v<Shape, Circle>) {
        add_circle(shape, amplitude, origin, direction);
      } else {
        const double scale = ComponentTable::v_scale(group), support = group.kernel.support;
        shape.along(origin, direction,
                    [&](const QuadraticPiece& piece) { add_piece(piece, scale, amplitude, support, t0, t1); });
      }
    });
  }

  template <class Kernel>
  HWY_INLINE void add_points(const Kernel& kernel, const ComponentTable& table, const std::uint32_t* items,
                             std::uint32_t count, const Vec3& origin, const Vec3& direction, double t0, double t1) {
    const Octet ox(origin.x), oy(origin.y), oz(origin.z), dx(direction.x), dy(direction.y), dz(direction.z);
    const double dd = direction.length2();
    const Octet inverse_dd(1 / dd), from(t0), to(t1), zero(0.0);
    Octet peaks(0.0);
    for (std::uint32_t i = 0; i < count; i += kOctet) {
      const std::uint32_t* const index = items + i;
      const OctetMask listed = first_lanes(std::min<std::uint32_t>(kOctet, count - i));
      const Octet cx = gather(table.x.data(), index) - ox;
      const Octet cy = gather(table.y.data(), index) - oy;
      const Octet cz = gather(table.z.data(), index) - oz;
      const Octet scale = gather(table.scale.data(), index);
      const Octet middle = (cx * dx + cy * dy + cz * dz) * inverse_dd;
      const Octet px = cx - middle * dx, py = cy - middle * dy, pz = cz - middle * dz;
      const Octet v0 = scale * (px * px + py * py + pz * pz);
      const Octet kappa = scale * Octet(dd);
      const Octet near = max(from, min(to, middle)) - middle;
      const Octet v_least = v0 + kappa * near * near;
      const OctetMask reaches = (v_least < kernel.support()) & listed;
      if (none(reaches)) continue;
      const Octet amplitude = gather(table.amplitude.data(), index);
      peaks = peaks + keep(reaches, max(amplitude, zero) * kernel.value(v_least));
      // Lanes that do not reach the stretch stay where they are: they are beyond their support all along it. (Moving
      // the others together costs more than it saves: lists are short.) Those past the list's end are put out of reach.
      double* const at = m_.quadratic.row(quadratics_);
      const std::size_t stride = m_.quadratic.stride();
      store(select(listed, v0, kernel.support() + kernel.support()), at + LaneMemory::kV0 * stride);
      store(keep(listed, kappa), at + LaneMemory::kKappa * stride);
      store(middle, at + LaneMemory::kMiddle * stride);
      store(amplitude, at + LaneMemory::kAmplitude * stride);
      quadratics_ += kOctet;
      sums_.field_count += static_cast<std::uint32_t>(std::popcount(bits(reaches)));
    }
    sums_.peak += sum(peaks);
  }

  static HWY_INLINE OctetMask first_lanes(std::uint32_t n) {
    alignas(64) static constexpr double kIndex[kOctet] = {0, 1, 2, 3, 4, 5, 6, 7};
    return load(kIndex) < Octet(static_cast<double>(n));
  }

  /// A piece of v = scale · q, unless it cannot reach the stretch.
  void add_piece(const QuadraticPiece& piece, double scale, double amplitude, double support, double t0, double t1) {
    const double v0 = scale * piece.q0, kappa = scale * piece.kappa;
    const double from = std::max(t0, piece.begin), to = std::min(t1, piece.end);
    if (!(from <= to)) return;
    const double near = std::clamp(piece.middle, from, to) - piece.middle;
    if (!(v0 + kappa * near * near < support)) return;
    m_.quadratic.set_row(quadratics_++, {v0, kappa, piece.middle, amplitude, piece.begin, piece.end});
  }

  [[nodiscard]] static Lines<double> line(const Vec3& o, const Vec3& d) { return {{o.x, o.y, o.z}, {d.x, d.y, d.z}}; }

  void add_cone(const Cone& cone, double amplitude, const Vec3& origin, const Vec3& direction) {
    const AboutAxis<double> seen = about_axis(cone.a, cone.axis, line(origin, direction));
    m_.cone.set_row(cones_++,
                    {seen.x0, seen.dx, seen.n0, seen.n2, seen.middle, cone.radius, cone.slope, cone.length, amplitude});
  }

  void add_circle(const Circle& circle, double amplitude, const Vec3& origin, const Vec3& direction) {
    const AboutAxis<double> seen = about_axis(circle.centre, circle.axis, line(origin, direction));
    m_.circle.set_row(circles_++, {seen.x0, seen.dx, seen.n0, seen.n2, seen.middle, circle.ring_radius,
                                   1 / (circle.radius * circle.radius), amplitude});
  }

  void add_curve(const Segment& segment, const KernelConstants& kernel, double amplitude, const Vec3& origin,
                 const Vec3& direction) {
    const double unit = per_support(kernel, segment), unit2 = unit * unit;
    const Vec3 end = segment.a + segment.axis * segment.length;
    const AboutAxis<double> from_a = about_axis(segment.a, segment.axis, line(origin, direction));
    const AboutAxis<double> from_b = about_axis(end, segment.axis, line(origin, direction));
    // From the nearer end: the farther one's distance would cost digits.
    const AboutAxis<double>& seen = std::abs(from_a.x0) < std::abs(from_b.x0) ? from_a : from_b;
    m_.segment.set_row(segments_++, {from_a.x0 * unit, -from_b.x0 * unit, seen.dx * unit, seen.n0 * unit2,
                                     seen.n2 * unit2, seen.middle, segment.length * unit, amplitude});
  }

  void add_curve(const Circle& ring, const KernelConstants& kernel, double amplitude, const Vec3& origin,
                 const Vec3& direction) {
    const double unit = per_support(kernel, ring), unit2 = unit * unit;
    const AboutAxis<double> seen = about_axis(ring.centre, ring.axis, line(origin, direction));
    m_.ring.set_row(rings_++, {seen.x0 * unit, seen.dx * unit, seen.n0 * unit2, seen.n2 * unit2, seen.middle,
                               ring.ring_radius * unit, amplitude});
  }

  /// Fills the last octets of convolved curves with lanes beyond their support.
  void pad_curves() {
    while ((segments_ - first_.segments) % kOctet != 0)
      m_.segment.set_row(segments_++, {0.5, 0.5, 1, 4, 0, 0, 1, 0});
    while ((rings_ - first_.rings) % kOctet != 0) m_.ring.set_row(rings_++, {kFar, 1, 1, 0, 0, 1, 0});
  }

  /// Fills the last octet of each form with lanes that add nothing.
  void pad(double support) {
    while ((quadratics_ - first_.quadratics) % kOctet != 0)
      m_.quadratic.set_row(quadratics_++, {2 * support, 0, 0, 0, -kInfinity, kInfinity});
    while ((cones_ - first_.cones) % kOctet != 0) m_.cone.set_row(cones_++, {0, 0, kInfinity, 0, 0, 1, 0, 0, 0});
    while ((circles_ - first_.circles) % kOctet != 0) m_.circle.set_row(circles_++, {kFar, 0, 1, 0, 0, 1, 1, 0});
  }

  /// Adds the greatest value that each lane can have on the stretch (add_points does so itself).
  template <class Kernel>
  void sum_up(const Kernel& kernel, const FieldGroup& group, double t0, double t1) {
    const Octet zero(0.0);
    Octet peaks(0.0);
    const auto add = [&](const OctetMask& reaches, const Octet& amplitude, const Octet& v_least)
                         HWY_ATTR { peaks = peaks + keep(reaches, max(amplitude, zero) * kernel.value(v_least)); };
    for (std::uint32_t i = first_.quadratics; i < quadratics_; i += kOctet) {
      const QuadraticLanes lane = load_quadratic(m_, i);
      const Octet from = max(Octet(t0), load_border(m_, i, LaneMemory::kBegin));
      const Octet to = min(Octet(t1), load_border(m_, i, LaneMemory::kEnd));
      const Octet near = max(zero, max(from - lane.middle, lane.middle - to));
      const Octet v_least = lane.v0 + lane.kappa * near * near;
      add(v_least < kernel.support(), lane.amplitude, v_least);
    }
    for (std::uint32_t i = first_.cones; i < cones_; i += kOctet) {
      const ConeLanes cone = load_cone(m_, i);
      const Octet v_least = cone.bounds(t0, t1, group.kernel.scale, group.kernel.support).least;
      add(v_least < kernel.support(), cone.amplitude, v_least);
    }
    for (std::uint32_t i = first_.circles; i < circles_; i += kOctet) {
      const CircleLanes circle = load_circle(m_, i);
      const Octet v_least = circle.bounds(t0, t1, group.kernel.scale, group.kernel.support).least;
      add(v_least < kernel.support(), circle.amplitude, v_least);
    }
    sums_.peak += sum(peaks);
  }

  void close_run(const FieldGroup& group) {
    const LaneSpan quadratics{first_.quadratics, quadratics_}, cones{first_.cones, cones_},
        circles{first_.circles, circles_}, segments{first_.segments, segments_}, rings{first_.rings, rings_};
    if (quadratics.is_empty() && cones.is_empty() && circles.is_empty() && segments.is_empty() && rings.is_empty())
      return;
    const bool has_pieces = group.skeleton != scene::Skeleton::point || group.is_mapped;
    m_.runs.push_back({&group.kernel, has_pieces, quadratics, cones, circles, segments, rings});
  }

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  /// Beyond any support, and its square finite.
  static constexpr double kFar = 1e100;

  LaneMemory& m_;
  LaneSums sums_;
  std::uint32_t quadratics_ = 0, cones_ = 0, circles_ = 0, segments_ = 0, rings_ = 0;  ///< rows in use
  struct {
    std::uint32_t quadratics, cones, circles, segments, rings;
  } first_{};  ///< of the run in the making
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
