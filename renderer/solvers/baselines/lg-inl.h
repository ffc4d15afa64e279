// LG-surfaces (Kalra and Barr 1989), certified: `lg`.
//
// L bounds |F′| on a region, and G bounds |F″|, the change of F′ along the ray. With the values in the middle m of an
// interval, where h is its width:
//   F(m) + Lh/2 < 0     no root;
//   |F′(m)| > Gh/2      F′ keeps its sign: at most one root, told by the ends, found by Newton's method;
//   else                halve the interval.
// In the paper, L belongs to the cells of an octree and holds in all directions. Here the grid's cells are culled in
// the same way for all solvers, and both L and G belong to the interval itself, along the ray.
//
// A ray that leaves the surface on which it starts has not come back while F′ < 0.
#if defined(ISL_RENDERER_SOLVERS_BASELINES_LG_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_BASELINES_LG_INL_H_
#undef ISL_RENDERER_SOLVERS_BASELINES_LG_INL_H_
#else
#define ISL_RENDERER_SOLVERS_BASELINES_LG_INL_H_
#endif

#include "renderer/solvers/baselines/bisection-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class LgSolver : public Bisection<LgSolver> {
 public:
  using Bisection::Bisection;

  [[nodiscard]] Verdict judge(const Node& a, const Node& b, bool a_is_root, std::optional<Node>& middle) {
    const double half = 0.5 * (b.t - a.t);
    const Node m = node(middle_of(a, b));
    middle = m;
    // A value within its rounding is no crossing.
    if (!a_is_root && m.value + half * size(slopes(a.t, b.t)) <= m.noise) return Verdict::none;
    const double change = half * size(bends(a.t, b.t)) + m.slope_noise;
    if (m.slope < -change) return Verdict::none;
    return m.slope > change && !a_is_root ? Verdict::rises : Verdict::unclear;
  }

  [[nodiscard]] double refine(const Node& a, const Node& b) { return newton(a, b); }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
