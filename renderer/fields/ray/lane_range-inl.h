// An enclosure of the sum of a cell's fields on an interval of a ray. Every field falls with the distance from its
// skeleton, so its least and greatest values follow from the greatest and least distances. The range is wider than that
// of the cubic of solvers/certified/hermite-inl.h where the cubic converges, but it is also useful where the cubic's
// error bound is not: near the peak of a hard Cauchy, whose fourth derivative is too great.
//
// The interval is widened to account for rounding of the ray's position: a computed point can be four half units in the
// last place of t away from the true one, along the ray and across it.
#if defined(ISL_RENDERER_FIELDS_RAY_LANE_RANGE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_RAY_LANE_RANGE_INL_H_
#undef ISL_RENDERER_FIELDS_RAY_LANE_RANGE_INL_H_
#else
#define ISL_RENDERER_FIELDS_RAY_LANE_RANGE_INL_H_
#endif

#include "renderer/fields/kernels/kernels-inl.h"
#include "renderer/fields/ray/lane_sums-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class LaneRange {
 public:
  LaneRange(double t0, double t1) : on_(t0, t1) {}

  [[nodiscard]] HWY_INLINE SumRange total() const { return sums_.total(); }

  // The functions of a visitor of visit_lanes (lane_walk-inl.h).

  template <class Kernel, class Borders>
  HWY_INLINE void add_quadratics(const Kernel& kernel, const QuadraticLanes& lane, const Borders& borders) {
    const OnPiece piece(borders, lane.middle, on_.t0, on_.t1, on_.drift);
    const Octet near = piece.near(), far = piece.far();
    const Octet across = sqrt(lane.v0), shift = sqrt(lane.kappa) * Octet(on_.drift) + error_of(borders);
    const Octet nearest = max(Octet(0.0), across - shift), farthest = across + shift;
    add(kernel, lane.amplitude, nearest * nearest + lane.kappa * near * near,
        farthest * farthest + lane.kappa * far * far, piece.whole, piece.any);
  }

  template <class Kernel, class Shape>
  HWY_INLINE void add_shape(const Kernel& kernel, const KernelConstants& constants, const Shape& lanes) {
    const auto v = lanes.bounds(on_.t0, on_.t1, constants.scale, constants.support);
    const OctetMask all = v.least <= v.least;
    const Octet farther = sqrt(v.greatest) + Octet(kPositionError) * lanes.size * sqrt(v.factor);
    add(kernel, lanes.amplitude, lanes.least(v), farther * farther, all, all);
  }

  template <class Window, class Curve>
  HWY_INLINE void add_curve(const Window& window, const Curve& lanes) {
    add_between(lanes.amplitude, lanes.least(window, on_.t0, on_.t1), lanes.most(window, on_.t0, on_.t1));
  }

 private:
  /// Adds the range for v between `least` and `greatest`. It includes 0 unless the `whole` interval is on this piece.
  template <class Kernel>
  HWY_INLINE void add(const Kernel& kernel, const Octet& amplitude, const Octet& least, const Octet& greatest,
                      const OctetMask& whole, const OctetMask& counts) {
    const Octet high = keep(counts & (least < kernel.support()), kernel.value(least));
    const Octet low = keep(counts & whole & (greatest < kernel.support()), kernel.value(greatest));
    add_between(amplitude, low, high);
  }

  HWY_INLINE void add_between(const Octet& amplitude, const Octet& low, const Octet& high) {
    const Octet one = amplitude * low, other = amplitude * high;
    sums_.add({min(one, other), max(one, other)});
  }

  WidenedInterval on_;
  RangeSums sums_;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
