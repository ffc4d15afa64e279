// The terms of a cell's sum and of its bounds, eight at a time: eight fields along one ray or one field along eight
// rays.
#if defined(ISL_RENDERER_FIELDS_RAY_LANE_VALUES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_RAY_LANE_VALUES_INL_H_
#undef ISL_RENDERER_FIELDS_RAY_LANE_VALUES_INL_H_
#else
#define ISL_RENDERER_FIELDS_RAY_LANE_VALUES_INL_H_
#endif

#include "renderer/fields/convolutions/curve_remainder-inl.h"
#include "renderer/fields/kernels/kernels-inl.h"
#include "renderer/fields/ray/lane_rows-inl.h"

#include <limits>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// f and f′, and how much f changes if positions are off by their `size` (PlacedLanes).
struct FieldTerm {
  Octet value, slope, moved;
};
/// The same of fields for which the setup has counted that (SetupSums::moved).
struct CountedTerm {
  Octet value, slope;
};

/// True for points of kernels for which the setup has one bound of `moved` for all places.
template <class Kernel, class Borders>
inline constexpr bool kIsCounted = NowhereSteep<Kernel>&& std::is_same_v<Borders, Everywhere>;

// If a distance is off by x = size · √v/distance in √v, f is off by |φ′(v)|(2√v x + x²). The rounding of positions is a
// small share of x, kPositionError, so that is what x² is multiplied by.

[[nodiscard]] HWY_INLINE Octet moved(const PieceBorders& piece, const Octet& steepness, const Octet& v) {
  const Octet root = sqrt(v), size = piece.size + root;
  return abs(steepness) * size * (Octet(2.0) * root + Octet(kPositionError) * size);
}
// For points, which are most of all fields, the same bound without a root. With c² = v at the surface, x = cz + √v and
// k = kPositionError, 2√v cz ≤ z(v + c²) and kx² ≤ 2k(c²z² + v), so all of it is at most (v + c²)(2 + 2k + z + 2kz²).
// At the surface this is right but for the constant; where v is 4 or a quarter of that, it is a quarter too much.
[[nodiscard]] HWY_INLINE Octet moved(const Everywhere& point, const Octet& steepness, const Octet& v) {
  return abs(steepness) * point.spread * (v + Octet(point.surface));
}

/// f and f′ of quadratics at t.
template <class Kernel, class Borders>
[[nodiscard]] HWY_INLINE auto field_at(const Kernel& kernel, const QuadraticLanes& lane, const Octet& t,
                                       const Borders& borders) {
  const Octet tau = t - lane.middle;
  const Octet kappa_tau = lane.kappa * tau;
  const Octet v = lane.v0 + kappa_tau * tau;
  const OctetMask active = borders.holds(v < kernel.support(), t);
  const KernelValue phi = kernel.value_and_slope(v);
  const Octet value = keep(active, lane.amplitude * phi.value);
  const Octet slope = keep(active, lane.amplitude * (phi.slope * (Octet(2.0) * kappa_tau)));
  if constexpr (kIsCounted<Kernel, Borders>) {
    return CountedTerm{value, slope};
  } else {
    return FieldTerm{value, slope, keep(active, moved(borders, lane.amplitude * phi.slope, v))};
  }
}

/// f and f′ of a ray form at t.
template <class Kernel, class Shapes>
[[nodiscard]] HWY_INLINE FieldTerm field_at(const Kernel& kernel, const Shapes& lanes, const Octet& t, double scale) {
  const LanePoint p = lanes.at(t, scale);
  const OctetMask active = p.v < kernel.support();
  const KernelValue phi = kernel.value_and_slope(p.v);
  const Octet root = sqrt(p.v), x = lanes.size * sqrt(p.factor) + root;
  return {keep(active, lanes.amplitude * phi.value), keep(active, lanes.amplitude * (phi.slope * p.slope)),
          keep(active, abs(lanes.amplitude * phi.slope) * x * (Octet(2.0) * root + Octet(kPositionError) * x))};
}

/// Σf and Σf′, and the scales of their rounding errors, Σ|f| and Σ|f′|.
struct FieldSums {
  Octet value, slope, magnitude, steepness;
  Octet moved;         ///< how much Σf changes if positions are off by their sizes
  Octet slope_excess;  ///< what the rounding errors of convolved slopes are in proportion to, besides `steepness`

  HWY_INLINE FieldSums() : value(0.0), slope(0.0), magnitude(0.0), steepness(0.0), moved(0.0), slope_excess(0.0) {}

  HWY_INLINE void add(const CountedTerm& f) {
    value = value + f.value;
    slope = slope + f.slope;
    magnitude = magnitude + abs(f.value);
    steepness = steepness + abs(f.slope);
  }
  HWY_INLINE void add(const FieldTerm& f) {
    add(CountedTerm{f.value, f.slope});
    moved = moved + f.moved;
  }
  /// Adds convolved curves, whose values are sums themselves and have their own scales of rounding errors.
  HWY_INLINE void add(const CurvePoint& p) {
    value = value + p.value;
    slope = slope + p.slope;
    magnitude = magnitude + p.value_terms;
    steepness = steepness + abs(p.slope);
    moved = moved + p.moved;
    slope_excess = slope_excess + p.slope_terms;
  }
};

/// Sums of the error bounds E and E′ of cubic Hermite interpolants of width h. Where f is smooth they are h⁴M₄/384 and
/// (√3/216)h³M₄, M₄ = max|f⁗|; where f is only C¹ they are (h²/32)·osc f″ and 0.126 h·osc f″, where osc includes the 0
/// beyond a border. If both hold, the lesser is used.
struct RemainderSums {
  Octet value, slope;

  HWY_INLINE RemainderSums() : value(0.0), slope(0.0) {}

  /// Adds quadratics; `part` is the part of an interval of width h on which they hold.
  template <class Kernel>
  HWY_INLINE void add_quadratics(const Kernel& kernel, const QuadraticLanes& lane, const HeldPart& part,
                                 const Octet& h) {
    const Octet a = part.from - lane.middle, b = part.to - lane.middle;
    const Octet near = max(Octet(0.0), max(a, Octet(0.0) - b));
    const Octet far = max(abs(a), abs(b));
    const Octet room = kernel.support() - lane.v0;  // κτ² at the border of the support
    const Octet u_near = lane.kappa * near * near, u_far = lane.kappa * far * far;
    const OctetMask smooth = part.whole & (u_far < room) & kernel.is_smooth(lane.v0 + u_near, lane.v0 + u_far);
    // If v is constant (inside a box or a half-space) the error is 0, whatever the kernel's slopes are there.
    const OctetMask counts = (u_near < room) & (part.from <= part.to) & (lane.kappa > Octet(0.0));
    add(kernel.on_quadratic(lane.v0, lane.kappa, u_near, min(u_far, room)), smooth, counts, lane.amplitude, h);
  }

  /// Adds a ray form on [t0, t1].
  template <class Kernel, class Shapes>
  HWY_INLINE void add_shapes(const Kernel& kernel, const Shapes& lanes, const Octet& t0, const Octet& t1, double scale,
                             double support) {
    const auto v = lanes.bounds(t0, t1, scale, support);
    const OctetMask counts = v.least < kernel.support();
    const OctetMask smooth = v.one_piece & (v.greatest < kernel.support()) & kernel.is_smooth(v.least, v.greatest);
    add(v.compose(kernel), smooth, counts, lanes.amplitude, t1 - t0);
  }

  /// Adds convolved segments or rings on [t0, t1].
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

// ---- Visitors of visit_lanes ----------------------------------------------------------------------------------------

/// Values and slopes at t.
struct ValuesAt {
  Octet t;
  FieldSums sums;

  HWY_INLINE explicit ValuesAt(const Octet& at) : t(at) {}
  template <class Kernel, class Borders>
  HWY_INLINE void add_quadratics(const Kernel& kernel, const QuadraticLanes& lanes, const Borders& borders) {
    sums.add(field_at(kernel, lanes, t, borders));
  }
  template <class Kernel, class Shapes>
  HWY_INLINE void add_shape(const Kernel& kernel, const KernelConstants& constants, const Shapes& lanes) {
    sums.add(field_at(kernel, lanes, t, constants.scale));
  }
  template <class Window, class Curves>
  HWY_INLINE void add_curve(const Window& window, const Curves& lanes) {
    sums.add(lanes.at(window, t));
  }
};

/// Remainders on [t0, t1].
struct RemaindersOn {
  Octet t0, t1, h;
  RemainderSums sums;

  HWY_INLINE RemaindersOn(const Octet& from, const Octet& to) : t0(from), t1(to), h(to - from) {}
  template <class Kernel, class Borders>
  HWY_INLINE void add_quadratics(const Kernel& kernel, const QuadraticLanes& lanes, const Borders& borders) {
    sums.add_quadratics(kernel, lanes, held_part(borders, t0, t1), h);
  }
  template <class Kernel, class Shapes>
  HWY_INLINE void add_shape(const Kernel& kernel, const KernelConstants& constants, const Shapes& lanes) {
    sums.add_shapes(kernel, lanes, t0, t1, constants.scale, constants.support);
  }
  template <class Window, class Curves>
  HWY_INLINE void add_curve(const Window& window, const Curves& lanes) {
    sums.add_curves(window, lanes, t0, t1);
  }
};

/// Second derivatives at t, one-sided where a border of a support or of a piece falls on t.
struct CurvatureAt {
  Octet t, sum;

  HWY_INLINE explicit CurvatureAt(const Octet& at) : t(at), sum(0.0) {}
  template <class Kernel, class Borders>
  HWY_INLINE void add_quadratics(const Kernel& kernel, const QuadraticLanes& lane, const Borders& borders) {
    const Octet tau = t - lane.middle;
    const Octet first = Octet(2.0) * lane.kappa * tau;
    const Octet v = lane.v0 + lane.kappa * tau * tau;
    const OctetMask active = borders.holds(v < kernel.support(), t);
    const Octet second =
        kernel.curvature(v) * first * first + kernel.value_and_slope(v).slope * (Octet(2.0) * lane.kappa);
    sum = sum + keep(active, lane.amplitude * second);
  }
  template <class Kernel, class Shapes>
  HWY_INLINE void add_shape(const Kernel& kernel, const KernelConstants& constants, const Shapes& lanes) {
    const LanePoint p = lanes.at(t, constants.scale);
    const OctetMask active = p.v < kernel.support();
    const Octet v2 = lanes.second(t, constants.scale);
    const Octet second = kernel.curvature(p.v) * p.slope * p.slope + kernel.value_and_slope(p.v).slope * v2;
    sum = sum + keep(active, lanes.amplitude * second);
  }
  /// Convolved fields are twice differentiable, so F″ is the difference quotient of the slopes at t ± η. With η = 2⁻¹⁷
  /// support radii, the errors from the slopes' rounding (2⁻⁵²/η) and from higher derivatives (η²) are both about 2⁻³⁴
  /// of F″.
  template <class Window, class Curves>
  HWY_INLINE void add_curve(const Window& window, const Curves& lanes) {
    const Octet step = Octet(0x1p-17) / lanes.speed();
    const Octet rise = lanes.at(window, t + step).slope - lanes.at(window, t - step).slope;
    sum = sum + Octet(0.5) * rise / step;
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
