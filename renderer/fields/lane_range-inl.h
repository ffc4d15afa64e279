// Between which values the sum of a cell's fields stays on an interval of a ray: every field falls with the distance from its
// skeleton, so its least and greatest values follow from the greatest and least distances. Coarser than the cubic of
// solvers/hermite-inl.h where that converges, but true where that knows nothing: about the pole of a hard Cauchy, whose fourth
// derivative is beyond any bound of use.
//
// Rounding of the ray's position is met by widening: a point at t may be computed four half units of t away, along the ray and
// across it.
#if defined(ISL_RENDERER_FIELDS_LANE_RANGE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_FIELDS_LANE_RANGE_INL_H_
#undef ISL_RENDERER_FIELDS_LANE_RANGE_INL_H_
#else
#define ISL_RENDERER_FIELDS_LANE_RANGE_INL_H_
#endif

#include "renderer/fields/kernels/kernels-inl.h"
#include "renderer/fields/lane_columns-inl.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// Of the sum of fields, the threshold not taken off.
struct SumRange {
  double low, high;
  double low_terms, high_terms;  ///< sums of the magnitudes of what these were summed from: what rounding is relative to
};

class LaneRange {
 public:
  LaneRange(const LaneMemory& memory, double t0, double t1)
      : m_(memory),
        drift_(0x1p-51 * std::max(std::abs(t0), std::abs(t1))),
        t0_(t0 - drift_),
        t1_(t1 + drift_),
        low_(0.0),
        high_(0.0),
        low_terms_(0.0),
        high_terms_(0.0) {}

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
      Octet from(t0_), to(t1_);
      OctetMask whole = from <= to;
      if (run.has_pieces) {
        const Octet begin = load_border(m_, i, LaneMemory::kBegin), end = load_border(m_, i, LaneMemory::kEnd);
        whole = (begin <= Octet(t0_ + drift_)) & (Octet(t1_ - drift_) <= end);
        from = max(from, begin - drift);
        to = min(to, end + drift);
      }
      const Octet a = from - lane.middle, b = to - lane.middle;
      const Octet near = max(zero, max(a, zero - b)), far = max(abs(a), abs(b));
      const Octet across = sqrt(lane.v0), shift = sqrt(lane.kappa) * drift;
      const Octet nearest = max(zero, across - shift), farthest = across + shift;
      add(kernel, lane.amplitude, nearest * nearest + lane.kappa * near * near,
          farthest * farthest + lane.kappa * far * far, whole, from <= to);
    }
  }

  template <class Kernel, class Load>
  HWY_INLINE void add_shapes(const Kernel& kernel, const LaneRun& run, const LaneSpan& rows, const Load& load_lanes) {
    for (std::uint32_t i = rows.first; i < rows.last; i += kOctet) {
      const auto lanes = load_lanes(m_, i);
      const auto v = lanes.bounds(t0_, t1_, run.kernel->scale, run.kernel->support);
      const OctetMask all = v.least <= v.least;
      add(kernel, lanes.amplitude, v.least, v.greatest, all, all);
    }
  }

  /// v between `least` and `greatest`; with less than the `whole` of the interval on this piece, 0 as well.
  template <class Kernel>
  HWY_INLINE void add(const Kernel& kernel, const Octet& amplitude, const Octet& least, const Octet& greatest,
                      const OctetMask& whole, const OctetMask& counts) {
    const Octet high = keep(counts & (least < kernel.support()), kernel.value(least));
    const Octet low = keep(counts & whole & (greatest < kernel.support()), kernel.value(greatest));
    add_between(amplitude, low, high);
  }

  template <class Window, class Load>
  HWY_INLINE void add_curves(const Window& window, const LaneSpan& rows, const Load& load_lanes) {
    for (std::uint32_t i = rows.first; i < rows.last; i += kOctet) {
      const auto lanes = load_lanes(m_, i);
      add_between(lanes.amplitude, Octet(0.0), lanes.most(window, t0_, t1_));
    }
  }

  HWY_INLINE void add_between(const Octet& amplitude, const Octet& low, const Octet& high) {
    const Octet one = amplitude * low, other = amplitude * high;
    const Octet least = min(one, other), most = max(one, other);
    low_ = low_ + least;
    high_ = high_ + most;
    low_terms_ = low_terms_ + abs(least);
    high_terms_ = high_terms_ + abs(most);
  }

  const LaneMemory& m_;
  double drift_, t0_, t1_;
  Octet low_, high_, low_terms_, high_terms_;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
