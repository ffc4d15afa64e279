// An enclosure of the derivative F′ of a cell's sum along an interval of a ray. Its greatest absolute value is the
// interval's directional Lipschitz bound; if F′ has one sign, F has at most one root in the interval.
//
// Quadratics are bounded by interval arithmetic: f′ = φ′(v)·v′, where the range of v′ = 2κτ is exact, and φ′ lies
// between its values at the least and the greatest v, since all kernels are convex (kernel_bounds-inl.h). Ray forms and
// convolved curves are bounded by the mean value theorem, f′(m) ± h/2 · max|f″|, m the midpoint; ray forms also by
// max|φ′| max|v′|.
//
// Rounding of the ray's position is treated as in lane_range-inl.h.
#if defined(ISL_RENDERER_FIELDS_RAY_LANE_SLOPE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_RAY_LANE_SLOPE_INL_H_
#undef ISL_RENDERER_FIELDS_RAY_LANE_SLOPE_INL_H_
#else
#define ISL_RENDERER_FIELDS_RAY_LANE_SLOPE_INL_H_
#endif

#include "renderer/fields/ray/lane_bend-inl.h"
#include "renderer/fields/ray/lane_sums-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class LaneSlope {
 public:
  LaneSlope(double t0, double t1) : on_(t0, t1) {}

  /// The enclosure of F′.
  [[nodiscard]] HWY_INLINE SumRange total() const { return sums_.total(); }

  // The functions of a visitor of visit_lanes (lane_walk-inl.h).

  template <class Kernel, class Borders>
  HWY_INLINE void add_quadratics(const Kernel& kernel, const QuadraticLanes& lane, const Borders& borders) {
    const OnPiece piece(borders, lane.middle, on_.t0, on_.t1, on_.drift);
    const Octet near = piece.near(), far = piece.far();
    const Octet across = sqrt(lane.v0), shift = sqrt(lane.kappa) * Octet(on_.drift) + error_of(borders);
    const Octet nearest = max(Octet(0.0), across - shift), farthest = across + shift;
    const Octet steep = slope_of(kernel, nearest * nearest + lane.kappa * near * near);
    const Octet flat = slope_of(kernel, farthest * farthest + lane.kappa * far * far);
    const Octet two_kappa = lane.kappa + lane.kappa;
    const Octet from = two_kappa * piece.a, to = two_kappa * piece.b;
    const OctetRange f{min(steep * to, flat * to), max(steep * from, flat * from)};
    sums_.add(scaled(piece.any, lane.amplitude, with_zero(piece.whole, f)));
  }

  template <class Kernel, class Shape>
  HWY_INLINE void add_shape(const Kernel& kernel, const KernelConstants& constants, const Shape& lanes) {
    const LanePoint p = lanes.at(middle(), constants.scale);
    const auto v = lanes.bounds(on_.t0, on_.t1, constants.scale, constants.support);
    const Octet steepest = v.steepest(kernel);
    const OctetRange by_bend = about(slope_of(kernel, p.v) * p.slope, LaneBend::of_shape(kernel, v));
    sums_.add(scaled(v.least < kernel.support(), lanes.amplitude,
                     {max(by_bend.low, Octet(0.0) - steepest), min(by_bend.high, steepest)}));
  }

  template <class Window, class Curve>
  HWY_INLINE void add_curve(const Window& window, Curve lanes) {
    const Octet amplitude = lanes.amplitude;
    lanes.amplitude = Octet(1.0);
    const CurvePoint p = lanes.at(window, middle());
    const Octet noise = Octet(0x1p-48) * p.slope_terms;
    const OctetRange r = about(p.slope, LaneBend::of_curve(window, lanes, on_.t0, on_.t1));
    sums_.add(scaled(all_lanes(), amplitude, {r.low - noise, r.high + noise}));
  }

 private:
  /// φ′(v) ≤ 0; it is 0 beyond the support.
  template <class Kernel>
  [[nodiscard]] static HWY_INLINE Octet slope_of(const Kernel& kernel, const Octet& v) {
    return keep(v < kernel.support(), kernel.value_and_slope(v).slope);
  }

  [[nodiscard]] HWY_INLINE Octet middle() const { return Octet(on_.t0 + 0.5 * (on_.t1 - on_.t0)); }

  /// The range of f′ on the interval, from its value at the midpoint and the range of f″.
  [[nodiscard]] HWY_INLINE OctetRange about(const Octet& slope, const OctetRange& bend) const {
    const Octet spread = Octet(0.5 * (on_.t1 - on_.t0)) * max(abs(bend.low), abs(bend.high));
    return {slope - spread, slope + spread};
  }

  WidenedInterval on_;
  RangeSums sums_;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
