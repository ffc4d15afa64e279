// The fields of one cell along eight rays, a ray in every lane: RayLanes turned by a quarter. Neighbouring rays meet the same
// cells, and then every field is read once for all of them and no lane stays empty, however short the list is.
#if defined(ISL_RENDERER_FIELDS_PACKET_PACKET_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_PACKET_PACKET_LANES_INL_H_
#undef ISL_RENDERER_FIELDS_PACKET_PACKET_LANES_INL_H_
#else
#define ISL_RENDERER_FIELDS_PACKET_PACKET_LANES_INL_H_
#endif

#include "renderer/fields/packet/packet_setup-inl.h"
#include "renderer/fields/ray/field_lanes-inl.h"

#include <cmath>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// What visit_rows adds up: values and slopes at t.
struct ValuesAt {
  Octet t;
  FieldSums sums;

  HWY_INLINE explicit ValuesAt(const Octet& at) : t(at) {}
  template <class Kernel>
  HWY_INLINE void add_points(const Kernel& kernel, const QuadraticLanes& lanes) {
    sums.add(field_at(kernel, lanes, t, [](const OctetMask& within) HWY_ATTR { return within; }));
  }
  template <class Kernel>
  HWY_INLINE void add_pieces(const Kernel& kernel, const QuadraticLanes& lanes, const PieceBorders& borders) {
    sums.add(field_at(kernel, lanes, t, [&](const OctetMask& within) HWY_ATTR {
      return within & (t >= borders.begin) & (t < borders.end);
    }));
  }
  template <class Kernel, class Shapes>
  HWY_INLINE void add_shape(const Kernel& kernel, const PacketRun& run, const Shapes& lanes) {
    sums.add(field_at(kernel, lanes, t, run.kernel->scale));
  }
  template <class Window, class Curves>
  HWY_INLINE void add_curve(const Window& window, const Curves& lanes) {
    sums.add(lanes.at(window, t));
  }
};

/// And remainders on [t0, t1].
struct RemaindersOn {
  Octet t0, t1, h;
  RemainderSums sums;

  HWY_INLINE RemaindersOn(const Octet& from, const Octet& to) : t0(from), t1(to), h(to - from) {}
  template <class Kernel>
  HWY_INLINE void add_points(const Kernel& kernel, const QuadraticLanes& lanes) {
    sums.add_quadratics(kernel, lanes, t0, t1, all_lanes(), h);
  }
  template <class Kernel>
  HWY_INLINE void add_pieces(const Kernel& kernel, const QuadraticLanes& lanes, const PieceBorders& borders) {
    const OctetMask whole = (borders.begin <= t0) & (t1 <= borders.end);
    sums.add_quadratics(kernel, lanes, max(t0, borders.begin), min(t1, borders.end), whole, h);
  }
  template <class Kernel, class Shapes>
  HWY_INLINE void add_shape(const Kernel& kernel, const PacketRun& run, const Shapes& lanes) {
    sums.add_shapes(kernel, lanes, t0, t1, run.kernel->scale, run.kernel->support);
  }
  template <class Window, class Curves>
  HWY_INLINE void add_curve(const Window& window, const Curves& lanes) {
    sums.add_curves(window, lanes, t0, t1);
  }
};

class PacketLanes {
 public:
  explicit PacketLanes(PacketMemory& memory) : m_(memory) {}

  /// Gathers the fields of a cell's list that reach the stretch of any of the rays in these lanes.
  void set_up(const ComponentTable& table, const std::uint32_t* items, std::uint32_t count, const RayPacket& rays,
              const OctetMask& lanes) {
    sums_ = PacketSetup(m_, rays, lanes).gather_list(table, items, count);
    threshold_ = table.threshold;
    relative_noise_ = Octet(0x1p-52) * (sums_.field_count + Octet(16.0 + 2 * sums_.exponent));
    threshold_noise_ = Octet(0x1p-52 * std::abs(threshold_)) * (sums_.field_count + Octet(16.0));
  }

  /// Where F − T can be above zero on the stretch, as for all that its bound knows where that is no number.
  [[nodiscard]] HWY_INLINE OctetMask may_be_inside() const {
    const Octet most = sums_.peak * (Octet(1.0) + relative_noise_) - Octet(threshold_) + threshold_noise_;
    return and_not(most < Octet(0.0), all_lanes());
  }
  /// Fields that reach the stretch of each ray.
  [[nodiscard]] HWY_INLINE const Octet& field_count() const { return sums_.field_count; }

  /// F − T and its derivative along each ray, with the bounds of their rounding (RayLanes::noise).
  struct FieldAt {
    Octet value, slope, noise, slope_noise;
  };
  [[nodiscard]] HWY_INLINE FieldAt at(const Octet& t) const {
    ValuesAt values(t);
    visit_rows(m_, values);
    const FieldSums& sums = values.sums;
    return {sums.value - Octet(threshold_), sums.slope,
            relative_noise_ * sums.magnitude + threshold_noise_ + Octet(0x1p-51) * abs(t) * sums.steepness,
            relative_noise_ * sums.steepness};
  }

  /// Of a cubic Hermite interpolant between t0 and t1.
  [[nodiscard]] HWY_INLINE RemainderSums remainder(const Octet& t0, const Octet& t1) const {
    RemaindersOn remainders(t0, t1);
    visit_rows(m_, remainders);
    return remainders.sums;
  }

 private:
  PacketMemory& m_;
  double threshold_ = 0;
  PacketSums sums_;
  Octet relative_noise_, threshold_noise_;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
