// Segment tracing (Galin, Guérin, Paris and Peytavie 2020): `segment`.
//
// This is sphere tracing with an L of the segment ahead only, along the ray: with L ≥ |F′| on [t, t + e] the ray goes
// min(|F|/L, e), or by the tolerance where that is farther, and the next segment is half as long again as that step. So
// segments grow where the field is flat, and shrink with the steps near the surface.
//
// A part thinner than the tolerance may be missed. A ray that starts on the surface begins by the tolerance away from
// it. After 16384 steps on a stretch, as in the paper's measurements, the rest is given up and counted as uncertified.
#if defined(ISL_RENDERER_SOLVERS_BASELINES_SEGMENT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_BASELINES_SEGMENT_INL_H_
#undef ISL_RENDERER_SOLVERS_BASELINES_SEGMENT_INL_H_
#else
#define ISL_RENDERER_SOLVERS_BASELINES_SEGMENT_INL_H_
#endif

#include "renderer/solvers/baselines/rival_solver-inl.h"

#include <algorithm>
#include <cmath>
#include <optional>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class SegmentSolver : public RivalSolver {
 public:
  using RivalSolver::RivalSolver;

  /// See HermiteSolver::first_root.
  [[nodiscard]] std::optional<double> first_root(Node a, const Node& last, bool a_is_root, bool any) {
    if (any && last.value > last.noise) return last.t;
    if (a_is_root) {
      if (!(a.t + tolerance(a.t) < last.t)) return std::nullopt;
      a = node(a.t + tolerance(a.t));
    }
    if (a.value > a.noise) return a.t;
    double segment = last.t - a.t;
    for (int i = 0; i < kMostSegments && !steps_.is_spent(); ++i) {
      segment = std::min(segment, last.t - a.t);
      const double free = std::abs(a.value) / size(slopes(a.t, a.t + segment));
      const double step = std::max(free < segment ? free : segment, tolerance(a.t));
      const Node b = a.t + step < last.t ? node(a.t + step) : last;
      if (b.value > b.noise) return any ? b.t : a.t + 0.5 * (b.t - a.t);
      if (!(b.t > a.t && b.t < last.t)) return std::nullopt;
      segment = kGrowth * step;
      a = b;
    }
    give_up_step();
    return std::nullopt;
  }

 private:
  static constexpr double kGrowth = 1.5;
  static constexpr int kMostSegments = 16384;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
