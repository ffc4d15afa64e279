// Interval arithmetic with bisection (Mitchell 1990), certified: `interval`.
//
// On an interval, F is enclosed by evaluating it with intervals; each field's own range is exact
// (fields/ray/lane_range-inl.h), so that only their sum is wider than need be. Where F stays below the threshold there
// is no root; where the enclosure of F′ has one sign there is at most one, and the ends tell; else the interval is
// halved.
//
// A ray that starts on the surface, leaving it, has not come back while F′ < 0.
#if defined(ISL_RENDERER_SOLVERS_BASELINES_INTERVAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_BASELINES_INTERVAL_INL_H_
#undef ISL_RENDERER_SOLVERS_BASELINES_INTERVAL_INL_H_
#else
#define ISL_RENDERER_SOLVERS_BASELINES_INTERVAL_INL_H_
#endif

#include "renderer/solvers/baselines/bisection-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class IntervalSolver : public Bisection<IntervalSolver> {
 public:
  using Bisection::Bisection;

  [[nodiscard]] Verdict judge(const Node& a, const Node& b, bool a_is_root, std::optional<Node>&) {
    // A value within its rounding is no crossing, and the range is wider than F by about as much: what exceeds neither
    // would be found again in every part.
    if (!a_is_root && values(a.t, b.t).high <= 2 * std::min(a.noise, b.noise)) return Verdict::none;
    const FieldRange slope = slopes(a.t, b.t);
    if (slope.high < 0) return Verdict::none;
    return slope.low > 0 && !a_is_root ? Verdict::rises : Verdict::unclear;
  }

  [[nodiscard]] double refine(const Node& a, const Node& b) { return newton(a, b); }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
