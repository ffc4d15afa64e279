// An enclosure of the second derivative F″ of a cell's sum along an interval of a ray: the sum of the bounds from the
// fields' kernels and windows. A field's range also includes 0 if the interval extends beyond the field's support or
// off its piece. Where f is only C¹ (at borders of pieces and supports, junctions of kernels) F″ jumps between bounded
// values, both of which are enclosed. So F′ is the integral of a function within the range, and
// F′(t) − F′(s) = (t − s)·[range].
//
// It serves solvers that bound the change of a slope: Kalra and Barr's G, and the inclusions of Aydinlilar and Zanni.
#if defined(ISL_RENDERER_FIELDS_RAY_LANE_BEND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_RAY_LANE_BEND_INL_H_
#undef ISL_RENDERER_FIELDS_RAY_LANE_BEND_INL_H_
#else
#define ISL_RENDERER_FIELDS_RAY_LANE_BEND_INL_H_
#endif

#include "renderer/fields/branches.h"
#include "renderer/fields/convolutions/curve_remainder-inl.h"
#include "renderer/fields/kernels/kernels-inl.h"
#include "renderer/fields/ray/lane_sums-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class LaneBend {
 public:
  LaneBend(double t0, double t1) : t0_(t0), t1_(t1), low_(0.0), high_(0.0) {}

  /// The enclosure of F″.
  [[nodiscard]] HWY_INLINE FieldRange total() const { return {sum(low_), sum(high_)}; }

  /// The range of f″ for a ray form, without the amplitude.
  template <class Kernel, class Bounds>
  [[nodiscard]] static HWY_INLINE OctetRange of_shape(const Kernel& kernel, const Bounds& v) {
    const SecondAndFourth f = v.compose(kernel);
    return with_zero(v.greatest < kernel.support(), {f.low, f.high});
  }
  /// The range of f″ for convolved curves, without the amplitude. The integral's ends move, but add nothing to f″
  /// (curve_remainder-inl.h).
  template <class Window, class Curve>
  [[nodiscard]] static HWY_INLINE OctetRange of_curve(const Window& window, const Curve& lanes, double t0, double t1) {
    const CurveStretch c = lanes.stretch(t0, t1);
    const WindowBounds b = window.bounds(c.y_least, c.e2, c.speed2);
    const Octet length = window.effective_length(c.length, c.y_least, c.spread);
    const OctetMask counts = c.y_least < Octet(1.0);
    const OctetRange f = sound({length * b.second_low, length * b.second_high});
    return {keep(counts, f.low), keep(counts, f.high)};
  }

  // The functions of a visitor of visit_lanes (lane_walk-inl.h).

  template <class Kernel, class Borders>
  HWY_INLINE void add_quadratics(const Kernel& kernel, const QuadraticLanes& lane, const Borders& borders) {
    const OnPiece piece(borders, lane.middle, t0_, t1_, 0);
    const Octet near = piece.near(), far = piece.far();
    const Octet room = kernel.support() - lane.v0;  // κτ² at the border of the support
    const Octet u_near = lane.kappa * near * near, u_far = lane.kappa * far * far;
    const SecondAndFourth f = kernel.on_quadratic(lane.v0, lane.kappa, u_near, min(u_far, room));
    add(scaled((u_near < room) & piece.any & (lane.kappa > Octet(0.0)), lane.amplitude,
               with_zero(piece.whole & (u_far < room), {f.low, f.high})));
  }

  template <class Kernel, class Shape>
  HWY_INLINE void add_shape(const Kernel& kernel, const KernelConstants& constants, const Shape& lanes) {
    const auto v = lanes.bounds(t0_, t1_, constants.scale, constants.support);
    add(scaled(v.least < kernel.support(), lanes.amplitude, of_shape(kernel, v)));
  }

  template <class Window, class Curve>
  HWY_INLINE void add_curve(const Window& window, const Curve& lanes) {
    add(scaled(Octet(0.0) <= Octet(0.0), lanes.amplitude, of_curve(window, lanes, t0_, t1_)));
  }

 private:
  HWY_INLINE void add(const OctetRange& r) {
    low_ = low_ + r.low;
    high_ = high_ + r.high;
  }

  double t0_, t1_;
  Octet low_, high_;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
