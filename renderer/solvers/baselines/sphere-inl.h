// Sphere tracing (Hart 1996): `sphere`, and over-relaxed (Keinert et al. 2014): `sphere:OMEGA`.
//
// With L ≥ |F′|, no root is nearer than |F|/L. The ray goes that far, or by the tolerance where that is farther, so
// that it arrives, until it is above the threshold. L belongs to the stretch of the ray in a cell: it is the sum of the
// fields' own bounds there. Hart's L holds in all space and all directions; with it, a ray in a sum of thousands of
// fields would not move.
//
// With over-relaxation, a step is OMEGA times as long. If the next sphere, |F|/L about the point that was reached, does
// not touch the last one, something between may have been passed: the step is taken back, and the rest of the stretch
// goes with OMEGA = 1.
//
// A part thinner than the tolerance may be missed. A ray that starts on the surface begins by the tolerance away from
// it. After 16384 steps on a stretch, where Galin et al. (2020) end too, the rest is given up and counted as
// uncertified.
#if defined(ISL_RENDERER_SOLVERS_BASELINES_SPHERE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_BASELINES_SPHERE_INL_H_
#undef ISL_RENDERER_SOLVERS_BASELINES_SPHERE_INL_H_
#else
#define ISL_RENDERER_SOLVERS_BASELINES_SPHERE_INL_H_
#endif

#include "renderer/solvers/baselines/rival_solver-inl.h"

#include <algorithm>
#include <cmath>
#include <optional>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class SphereSolver : public RivalSolver {
 public:
  using RivalSolver::RivalSolver;

  /// See HermiteSolver::first_root.
  [[nodiscard]] std::optional<double> first_root(Node a, const Node& last, bool a_is_root, bool any) {
    if (any && last.value > last.noise) return last.t;
    const double steepest = size(slopes(a.t, last.t));
    double omega = lengths_.settings->relaxation;
    if (a_is_root) {
      if (!(a.t + tolerance(a.t) < last.t)) return std::nullopt;
      a = node(a.t + tolerance(a.t));
    }
    if (a.value > a.noise) return a.t;
    for (int i = 0; i < kMostSpheres && !steps_.is_spent(); ++i) {
      const double radius = std::abs(a.value) / steepest, least = tolerance(a.t);
      double step = std::max(omega * radius, least);
      Node b = last;
      if (a.t + step < last.t) {
        b = node(a.t + step);
      } else {
        step = last.t - a.t;
      }
      const bool is_unsafe = step > std::max(radius, least);
      if (is_unsafe && (b.value > 0 || radius + std::abs(b.value) / steepest < step)) {
        omega = 1;
        continue;
      }
      if (b.value > b.noise) return any || is_unsafe ? b.t : a.t + 0.5 * (b.t - a.t);
      if (!(b.t > a.t && b.t < last.t)) return std::nullopt;
      a = b;
    }
    give_up_step();
    return std::nullopt;
  }

 private:
  static constexpr int kMostSpheres = 16384;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
