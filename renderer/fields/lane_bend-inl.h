// Between which values the second derivative F″ of a cell's sum stays along an interval of a ray: the sum of what the
// fields' kernels and windows bound, each with 0 as well where the interval reaches beyond its support or off its
// piece. Where f is only C¹ (at borders of pieces and supports, junctions of kernels) F″ jumps between bounded values,
// both of which are enclosed: so F′ is the integral of something in the range, and F′(t) − F′(s) = (t − s)·[range].
//
// For solvers that bound the change of a slope: Kalra and Barr's G, the inclusions of Aydinlilar and Zanni.
#if defined(ISL_RENDERER_FIELDS_LANE_BEND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_LANE_BEND_INL_H_
#undef ISL_RENDERER_FIELDS_LANE_BEND_INL_H_
#else
#define ISL_RENDERER_FIELDS_LANE_BEND_INL_H_
#endif

#include "renderer/fields/branches.h"
#include "renderer/fields/convolutions/curve_remainder-inl.h"
#include "renderer/fields/kernels/kernels-inl.h"
#include "renderer/fields/lane_columns-inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

struct OctetRange {
  Octet low, high;
};

/// Where kernels overflow (a hardness of hundreds, inside) products of bounds say nothing: anything, then.
[[nodiscard]] HWY_INLINE OctetRange sound(const OctetRange& r) {
  const Octet infinite(std::numeric_limits<double>::infinity());
  const OctetMask is_range = r.low <= r.high;
  return {select(is_range, r.low, Octet(0.0) - infinite), select(is_range, r.high, infinite)};
}
[[nodiscard]] HWY_INLINE OctetRange with_zero(const OctetMask& keeps, const OctetRange& range) {
  const Octet zero(0.0);
  const OctetRange r = sound(range);
  return {select(keeps, r.low, min(r.low, zero)), select(keeps, r.high, max(r.high, zero))};
}
/// The range times a number of either sign; {0, 0} where not `counts`.
[[nodiscard]] HWY_INLINE OctetRange scaled(const OctetMask& counts, const Octet& amplitude, const OctetRange& range) {
  const OctetRange r = sound(range);
  const Octet one = amplitude * r.low, other = amplitude * r.high;
  return {keep(counts, min(one, other)), keep(counts, max(one, other))};
}

/// The part of an interval that lies on a piece, seen from the piece's middle.
struct OnPiece {
  Octet a, b;       ///< ends
  OctetMask whole;  ///< it is all of the interval
  OctetMask any;    ///< it is not empty

  HWY_INLINE OnPiece(const LaneMemory& memory, const LaneRun& run, std::uint32_t i, const Octet& middle, double t0,
                     double t1) {
    Octet from(t0), to(t1);
    whole = from <= to;
    if (run.has_pieces) {
      const Octet begin = load_border(memory, i, LaneMemory::kBegin), end = load_border(memory, i, LaneMemory::kEnd);
      whole = (begin <= from) & (to <= end);
      from = max(from, begin);
      to = min(to, end);
    }
    any = from <= to;
    a = from - middle;
    b = to - middle;
  }
  [[nodiscard]] HWY_INLINE Octet near() const { return max(Octet(0.0), max(a, Octet(0.0) - b)); }
  [[nodiscard]] HWY_INLINE Octet far() const { return max(abs(a), abs(b)); }
};

class LaneBend {
 public:
  LaneBend(const LaneMemory& memory, double t0, double t1) : m_(memory), t0_(t0), t1_(t1), low_(0.0), high_(0.0) {}

  /// Of F″.
  [[nodiscard]] HWY_NOINLINE FieldRange range() {
    for (const LaneRun& run : m_.runs) {
      if (run.kernel->is_convolved) {
        with_window(*run.kernel, [&](const auto& window) HWY_ATTR {
          add_curves(window, run.segments, load_segment);
          add_curves(window, run.rings, load_ring);
        });
      } else {
        with_kernel(*run.kernel, [&](const auto& kernel) HWY_ATTR {
          add_quadratics(kernel, run);
          add_shapes(kernel, run, run.cones, load_cone);
          add_shapes(kernel, run, run.circles, load_circle);
        });
      }
    }
    return {sum(low_), sum(high_)};
  }

  /// The range of f″ of lanes that are no quadratics, amplitude apart.
  template <class Kernel, class Bounds>
  [[nodiscard]] static HWY_INLINE OctetRange of_shape(const Kernel& kernel, const Bounds& v) {
    const SecondAndFourth f = v.compose(kernel);
    return with_zero(v.greatest < kernel.support(), {f.low, f.high});
  }
  /// The same of convolved curves. The integral's ends move, but add nothing to f″ (curve_remainder-inl.h).
  template <class Window, class Curve>
  [[nodiscard]] static HWY_INLINE OctetRange of_curve(const Window& window, const Curve& lanes, double t0, double t1) {
    const CurveStretch c = lanes.stretch(t0, t1);
    const WindowBounds b = window.bounds(c.y_least, c.e2, c.speed2);
    const Octet length = window.effective_length(c.length, c.y_least, c.spread);
    const OctetMask counts = c.y_least < Octet(1.0);
    const OctetRange f = sound({length * b.second_low, length * b.second_high});
    return {keep(counts, f.low), keep(counts, f.high)};
  }

 private:
  template <class Kernel>
  HWY_INLINE void add_quadratics(const Kernel& kernel, const LaneRun& run) {
    for (std::uint32_t i = run.quadratics.first; i < run.quadratics.last; i += kOctet) {
      const QuadraticLanes lane = load_quadratic(m_, i);
      const OnPiece piece(m_, run, i, lane.middle, t0_, t1_);
      const Octet near = piece.near(), far = piece.far();
      const Octet room = kernel.support() - lane.v0;  // κτ² where the support ends
      const Octet u_near = lane.kappa * near * near, u_far = lane.kappa * far * far;
      const SecondAndFourth f = kernel.on_quadratic(lane.v0, lane.kappa, u_near, min(u_far, room));
      add(scaled((u_near < room) & piece.any & (lane.kappa > Octet(0.0)), lane.amplitude,
                 with_zero(piece.whole & (u_far < room), {f.low, f.high})));
    }
  }

  template <class Kernel, class Load>
  HWY_INLINE void add_shapes(const Kernel& kernel, const LaneRun& run, const LaneSpan& rows, const Load& load_lanes) {
    for (std::uint32_t i = rows.first; i < rows.last; i += kOctet) {
      const auto lanes = load_lanes(m_, i);
      const auto v = lanes.bounds(t0_, t1_, run.kernel->scale, run.kernel->support);
      add(scaled(v.least < kernel.support(), lanes.amplitude, of_shape(kernel, v)));
    }
  }

  template <class Window, class Load>
  HWY_INLINE void add_curves(const Window& window, const LaneSpan& rows, const Load& load_lanes) {
    for (std::uint32_t i = rows.first; i < rows.last; i += kOctet) {
      const auto lanes = load_lanes(m_, i);
      add(scaled(Octet(0.0) <= Octet(0.0), lanes.amplitude, of_curve(window, lanes, t0_, t1_)));
    }
  }

  HWY_INLINE void add(const OctetRange& r) {
    low_ = low_ + r.low;
    high_ = high_ + r.high;
  }

  const LaneMemory& m_;
  double t0_, t1_;
  Octet low_, high_;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
