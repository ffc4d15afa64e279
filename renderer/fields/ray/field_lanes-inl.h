// The terms of a cell's sum and of its bounds, eight at a time: eight fields along one ray (ray_lanes-inl.h) or one field
// along eight rays (packet_lanes-inl.h).
#if defined(ISL_RENDERER_FIELDS_RAY_FIELD_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_RAY_FIELD_LANES_INL_H_
#undef ISL_RENDERER_FIELDS_RAY_FIELD_LANES_INL_H_
#else
#define ISL_RENDERER_FIELDS_RAY_FIELD_LANES_INL_H_
#endif

#include "renderer/fields/kernels/kernels-inl.h"
#include "renderer/fields/ray/lane_columns-inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// f and f′.
struct FieldTerm {
  Octet value, slope;
};

/// Of quadratics at t. `on_piece` is handed where t lies within the support and takes away where the quadratic does not hold.
template <class Kernel, class OnPiece>
[[nodiscard]] HWY_INLINE FieldTerm field_at(const Kernel& kernel, const QuadraticLanes& lane, const Octet& t,
                                            const OnPiece& on_piece) {
  const Octet tau = t - lane.middle;
  const Octet kappa_tau = lane.kappa * tau;
  const Octet v = lane.v0 + kappa_tau * tau;
  const OctetMask active = on_piece(v < kernel.support());
  const KernelValue phi = kernel.value_and_slope(v);
  return {keep(active, lane.amplitude * phi.value),
          keep(active, lane.amplitude * (phi.slope * (Octet(2.0) * kappa_tau)))};
}

/// Of cones or circles.
template <class Kernel, class Shapes>
[[nodiscard]] HWY_INLINE FieldTerm field_at(const Kernel& kernel, const Shapes& lanes, const Octet& t, double scale) {
  const LanePoint p = lanes.at(t, scale);
  const OctetMask active = p.v < kernel.support();
  const KernelValue phi = kernel.value_and_slope(p.v);
  return {keep(active, lanes.amplitude * phi.value), keep(active, lanes.amplitude * (phi.slope * p.slope))};
}

/// Σf, Σf′ and what their rounding is relative to, Σ|f| and Σ|f′|.
struct FieldSums {
  Octet value, slope, magnitude, steepness;

  HWY_INLINE FieldSums() : value(0.0), slope(0.0), magnitude(0.0), steepness(0.0) {}

  HWY_INLINE void add(const FieldTerm& f) {
    value = value + f.value;
    slope = slope + f.slope;
    magnitude = magnitude + abs(f.value);
    steepness = steepness + abs(f.slope);
  }
  /// Of convolved curves, which are sums themselves.
  HWY_INLINE void add(const CurvePoint& p) {
    value = value + p.value;
    slope = slope + p.slope;
    magnitude = magnitude + p.value_terms;
    steepness = steepness + p.slope_terms;
  }
};

/// E and E′ of a cubic Hermite interpolant of width h. In the smooth case h⁴M₄/384 and (√3/216)h³M₄; where f is only
/// C¹, (h²/32)·osc f″ and 0.126 h·osc f″, osc counting the 0 beyond a border. The lesser of both where both hold.
struct RemainderSums {
  Octet value, slope;

  HWY_INLINE RemainderSums() : value(0.0), slope(0.0) {}

  /// Of the parts [from, to] of an interval of width h that lie on the quadratics, all of it where `whole`.
  template <class Kernel>
  HWY_INLINE void add_quadratics(const Kernel& kernel, const QuadraticLanes& lane, const Octet& from, const Octet& to,
                                 const OctetMask& whole, const Octet& h) {
    const Octet a = from - lane.middle, b = to - lane.middle;
    const Octet near = max(Octet(0.0), max(a, Octet(0.0) - b));
    const Octet far = max(abs(a), abs(b));
    const Octet room = kernel.support() - lane.v0;  // κτ² where the support ends
    const Octet u_near = lane.kappa * near * near, u_far = lane.kappa * far * far;
    const OctetMask smooth = whole & (u_far < room) & kernel.is_smooth(lane.v0 + u_near, lane.v0 + u_far);
    // Where v does not change (inside a box or a half-space) there is no error, whatever the kernel's slopes are there.
    const OctetMask counts = (u_near < room) & (from <= to) & (lane.kappa > Octet(0.0));
    add(kernel.on_quadratic(lane.v0, lane.kappa, u_near, min(u_far, room)), smooth, counts, lane.amplitude, h);
  }

  /// Of cones or circles on [t0, t1].
  template <class Kernel, class Shapes>
  HWY_INLINE void add_shapes(const Kernel& kernel, const Shapes& lanes, const Octet& t0, const Octet& t1, double scale,
                             double support) {
    const auto v = lanes.bounds(t0, t1, scale, support);
    const OctetMask counts = v.least < kernel.support();
    const OctetMask smooth = v.one_piece & (v.greatest < kernel.support()) & kernel.is_smooth(v.least, v.greatest);
    add(v.compose(kernel), smooth, counts, lanes.amplitude, t1 - t0);
  }

  /// Of convolved segments or rings on [t0, t1].
  template <class Window, class Curves>
  HWY_INLINE void add_curves(const Window& window, const Curves& lanes, const Octet& t0, const Octet& t1) {
    const CurveRemainder r = curve_remainder(window, lanes.stretch(t0, t1), t1 - t0);
    const Octet size = abs(lanes.amplitude);
    value = value + size * r.value;
    slope = slope + size * r.slope;
  }

 private:
  HWY_INLINE void add(const SecondAndFourth& bounds, const OctetMask& smooth, const OctetMask& counts,
                      const Octet& amplitude, const Octet& h) {
    const Octet zero(0.0), size = abs(amplitude);
    const Octet spread = select(smooth, bounds.high - bounds.low, max(bounds.high, zero) - min(bounds.low, zero));
    const Octet fourth = select(smooth, bounds.fourth, Octet(std::numeric_limits<double>::infinity()));
    const Octet h2 = h * h;
    const Octet e = min(h2 * Octet(1.0 / 32) * spread, h2 * h2 * Octet(1.0 / 384) * fourth);
    const Octet e1 = min(Octet(0.126) * h * spread, Octet(0.00801876) * h2 * h * fourth);  // √3/216
    value = value + keep(counts, size * e);
    slope = slope + keep(counts, size * e1);
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
