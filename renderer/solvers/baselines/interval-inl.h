// Interval arithmetic with bisection (Mitchell 1990), certified: `interval`.
//
// On an interval, F is enclosed by evaluating it with intervals. Each field's own range is exact
// (fields/ray/lane_range-inl.h), so that only their sum is wider than it need be. If F stays below the threshold, there
// is no root. If the enclosure of F′ has one sign, there is at most one, and the ends tell. Otherwise the interval is
// halved.
//
// A ray that leaves the surface on which it starts has not come back while F′ < 0.
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
    // A value within its rounding is no crossing, and the range is wider than F by about as much. An interval that
    // exceeds neither would be undecided again in every part. The rounding at its ends may be far greater than between
    // them, as where a ray passes through the hole of a ring.
    if (!a_is_root && values(a.t, b.t).high <= 2 * fields_.least_noise()) return Verdict::none;
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
