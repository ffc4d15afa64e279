// Between which values the derivative F′ of a cell's sum stays along an interval of a ray. Its greatest size is the
// directional Lipschitz bound of the interval; where it has one sign, F has no more than one root.
//
// Quadratics in interval arithmetic: f′ = φ′(v)·v′ with v′ = 2κτ exact between its ends, and φ′ between its values at
// the least and the greatest v, all kernels being convex (kernel_bounds-inl.h). Cones, circles and convolved curves by
// the mean value, f′(m) ± h/2 · max|f″|, m the middle, and the first two no steeper than max|φ′| max|v′|.
//
// Rounding of the ray's position is met as in lane_range-inl.h.
#if defined(ISL_RENDERER_FIELDS_LANE_SLOPE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_LANE_SLOPE_INL_H_
#undef ISL_RENDERER_FIELDS_LANE_SLOPE_INL_H_
#else
#define ISL_RENDERER_FIELDS_LANE_SLOPE_INL_H_
#endif

#include "renderer/fields/lane_bend-inl.h"
#include "renderer/fields/lane_range-inl.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class LaneSlope {
 public:
  LaneSlope(const LaneMemory& memory, double t0, double t1)
      : m_(memory),
        drift_(0x1p-51 * std::max(std::abs(t0), std::abs(t1))),
        t0_(t0 - drift_),
        t1_(t1 + drift_),
        low_(0.0),
        high_(0.0),
        low_terms_(0.0),
        high_terms_(0.0) {}

  /// Of F′.
  [[nodiscard]] HWY_NOINLINE SumRange sum_range() {
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
    return {sum(low_), sum(high_), sum(low_terms_), sum(high_terms_)};
  }

 private:
  template <class Kernel>
  HWY_INLINE void add_quadratics(const Kernel& kernel, const LaneRun& run) {
    const Octet zero(0.0), drift(drift_);
    for (std::uint32_t i = run.quadratics.first; i < run.quadratics.last; i += kOctet) {
      const QuadraticLanes lane = load_quadratic(m_, i);
      const OnPiece piece(m_, run, i, lane.middle, t0_, t1_);
      const Octet near = piece.near(), far = piece.far();
      const Octet across = sqrt(lane.v0), shift = sqrt(lane.kappa) * drift;
      const Octet nearest = max(zero, across - shift), farthest = across + shift;
      const Octet steep = slope_of(kernel, nearest * nearest + lane.kappa * near * near);
      const Octet flat = slope_of(kernel, farthest * farthest + lane.kappa * far * far);
      const Octet two_kappa = lane.kappa + lane.kappa;
      const Octet from = two_kappa * piece.a, to = two_kappa * piece.b;
      const OctetRange f{min(steep * to, flat * to), max(steep * from, flat * from)};
      add(scaled(piece.any, lane.amplitude, with_zero(piece.whole, f)));
    }
  }
  /// φ′ ≤ 0, and 0 beyond the support.
  template <class Kernel>
  [[nodiscard]] static HWY_INLINE Octet slope_of(const Kernel& kernel, const Octet& v) {
    return keep(v < kernel.support(), kernel.value_and_slope(v).slope);
  }

  template <class Kernel, class Load>
  HWY_INLINE void add_shapes(const Kernel& kernel, const LaneRun& run, const LaneSpan& rows, const Load& load_lanes) {
    const Octet middle(t0_ + 0.5 * (t1_ - t0_));
    for (std::uint32_t i = rows.first; i < rows.last; i += kOctet) {
      const auto lanes = load_lanes(m_, i);
      const LanePoint p = lanes.at(middle, run.kernel->scale);
      const auto v = lanes.bounds(t0_, t1_, run.kernel->scale, run.kernel->support);
      const Octet steepest = v.steepest(kernel);
      const OctetRange by_bend = about(slope_of(kernel, p.v) * p.slope, LaneBend::of_shape(kernel, v));
      add(scaled(v.least < kernel.support(), lanes.amplitude,
                 {max(by_bend.low, Octet(0.0) - steepest), min(by_bend.high, steepest)}));
    }
  }

  template <class Window, class Load>
  HWY_INLINE void add_curves(const Window& window, const LaneSpan& rows, const Load& load_lanes) {
    const Octet middle(t0_ + 0.5 * (t1_ - t0_));
    const OctetMask all = middle <= middle;
    for (std::uint32_t i = rows.first; i < rows.last; i += kOctet) {
      auto lanes = load_lanes(m_, i);
      const Octet amplitude = lanes.amplitude;
      lanes.amplitude = Octet(1.0);
      const CurvePoint p = lanes.at(window, middle);
      const Octet noise = Octet(0x1p-48) * p.slope_terms;
      const OctetRange r = about(p.slope, LaneBend::of_curve(window, lanes, t0_, t1_));
      add(scaled(all, amplitude, {r.low - noise, r.high + noise}));
    }
  }

  /// What f′ can be within half the interval's width of where it is this.
  [[nodiscard]] HWY_INLINE OctetRange about(const Octet& slope, const OctetRange& bend) const {
    const Octet spread = Octet(0.5 * (t1_ - t0_)) * max(abs(bend.low), abs(bend.high));
    return {slope - spread, slope + spread};
  }

  HWY_INLINE void add(const OctetRange& r) {
    low_ = low_ + r.low;
    high_ = high_ + r.high;
    low_terms_ = low_terms_ + abs(r.low);
    high_terms_ = high_terms_ + abs(r.high);
  }

  const LaneMemory& m_;
  double drift_, t0_, t1_;
  Octet low_, high_, low_terms_, high_terms_;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
