// Hill climbing, with which the published solver was compared (Sherstyuk 1999): `climb:STEP`.
//
// The steps are fixed, and F is evaluated at t and t + δ, δ = STEP/1024, so that the slope is known too. Above the
// threshold, regula falsi finds the root. Where F rises at one step and falls at the next, both below the threshold,
// there is a hill between: it is climbed, halving towards its top by the slope, until F is above the threshold or the
// hill ends below it. The paper gives no more than the idea. If there are two hills between neighbouring steps, either
// both are missed or the nearer one is.
//
// A ray that starts on the surface begins one step away from it, as in march-inl.h.
#if defined(ISL_RENDERER_SOLVERS_BASELINES_CLIMB_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_BASELINES_CLIMB_INL_H_
#undef ISL_RENDERER_SOLVERS_BASELINES_CLIMB_INL_H_
#else
#define ISL_RENDERER_SOLVERS_BASELINES_CLIMB_INL_H_
#endif

#include "renderer/solvers/baselines/rival_solver-inl.h"

#include <algorithm>
#include <optional>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class ClimbSolver : public RivalSolver {
 public:
  using RivalSolver::RivalSolver;

  /// See HermiteSolver::first_root.
  [[nodiscard]] std::optional<double> first_root(Node a, const Node& last, bool a_is_root, bool any) {
    if (!a_is_root && a.value > a.noise) return a.t;
    if (any && last.value > last.noise) return last.t;
    const double least = (last.t - a.t) / kMostSteps;
    delta_ = std::max(step(a.t), least) / 1024;
    if (!a_is_root) a.slope = rise(a);
    while (a.t < last.t && !gives_up()) {
      const double t = a.t + std::max(step(a.t), least);
      if (a_is_root && !(t < last.t)) break;
      Node b = t < last.t ? node(t) : last;
      if (b.value > b.noise) return any || a_is_root ? b.t : regula_falsi(a, b);
      b.slope = rise(b);
      if (!a_is_root && a.slope > 0 && b.slope < 0) {
        if (const std::optional<Node> top = climb(a, b)) return any ? top->t : regula_falsi(a, *top);
      }
      a = b;
      a_is_root = false;
    }
    return std::nullopt;
  }

 private:
  /// The change of F over the distance δ ahead.
  [[nodiscard]] double rise(const Node& at) { return node(at.t + delta_).value - at.value; }

  /// A point above the threshold on the hill between two points below it. A hill narrower than the tolerance is
  /// ignored.
  [[nodiscard]] std::optional<Node> climb(Node a, Node b) {
    const double enough = tolerance(a.t);
    for (int i = 0; i < kMostHalvings && b.t - a.t > enough; ++i) {
      Node m = node(a.t + 0.5 * (b.t - a.t));
      if (m.value > m.noise) return m;
      m.slope = rise(m);
      (m.slope > 0 ? a : b) = m;
    }
    return std::nullopt;
  }

  double delta_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
