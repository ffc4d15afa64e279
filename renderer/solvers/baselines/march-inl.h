// Ray marching (Tuy and Tuy 1984; Perlin and Hoffert 1989): `march:STEP`.
//
// F is sampled at fixed steps until it is above the threshold; the last step is halved until it is no longer than the
// tolerance. A part thinner than a step is missed, as are two crossings between samples. Cells that hold no surface are
// left out here as for all solvers. Each of the other cells is sampled at both its ends too, which only finds more.
//
// A ray that starts on the surface begins one step away from it. It does not see anything before that, and if it is
// still on the other side then, it finds the surface that it left.
#if defined(ISL_RENDERER_SOLVERS_BASELINES_MARCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_BASELINES_MARCH_INL_H_
#undef ISL_RENDERER_SOLVERS_BASELINES_MARCH_INL_H_
#else
#define ISL_RENDERER_SOLVERS_BASELINES_MARCH_INL_H_
#endif

#include "renderer/solvers/baselines/rival_solver-inl.h"

#include <algorithm>
#include <optional>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class MarchSolver : public RivalSolver {
 public:
  using RivalSolver::RivalSolver;

  /// See HermiteSolver::first_root.
  [[nodiscard]] std::optional<double> first_root(Node a, const Node& last, bool a_is_root, bool any) {
    if (!a_is_root && a.value > a.noise) return a.t;
    const double least = (last.t - a.t) / kMostSteps;
    while (a.t < last.t && !gives_up()) {
      const double t = a.t + std::max(step(a.t), least);
      if (a_is_root && !(t < last.t)) break;
      const Node b = t < last.t ? node(t) : last;
      if (b.value > b.noise) return any || a_is_root ? b.t : halve(a.t, b.t);
      a = b;
      a_is_root = false;
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] double halve(double outside, double inside) {
    const double enough = tolerance(outside);
    for (int i = 0; i < kMostHalvings && inside - outside > enough; ++i) {
      const double t = outside + 0.5 * (inside - outside);
      (node(t).value > 0 ? inside : outside) = t;
    }
    return outside + 0.5 * (inside - outside);
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
