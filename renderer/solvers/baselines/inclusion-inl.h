// Forward inclusion of second order (Aydinlilar and Zanni 2023), certified: `inclusion`.
//
// From a point t on the ray, with m ≤ F″ ≤ M on [t, t + e],
//   F(t) + F′(t)x + mx²/2 ≤ F(t + x) ≤ F(t) + F′(t)x + Mx²/2   for x in [0, e],
// These bounds are exact where they start. No root lies before the first root of the upper parabola, so the ray goes
// that far, and the closer it comes the better the parabola is. Where F′(t) + min(m, 0)e > 0, F rises all along, and
// its value at the end tells whether it has its one root there, which Newton's method finds. The next stretch is twice
// as long as the last step.
//
// A ray that starts on the surface has F(t) = 0 and divides the root out: the upper parabola comes back at x =
// −2F′(t)/M.
//
// A step shorter than the tolerance asks to tell apart is replaced by one of that length, counted as uncertified, and
// the next such step is twice as long. So a search along a surface ends.
#if defined(ISL_RENDERER_SOLVERS_BASELINES_INCLUSION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_BASELINES_INCLUSION_INL_H_
#undef ISL_RENDERER_SOLVERS_BASELINES_INCLUSION_INL_H_
#else
#define ISL_RENDERER_SOLVERS_BASELINES_INCLUSION_INL_H_
#endif

#include "renderer/solvers/baselines/rival_solver-inl.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class InclusionSolver : public RivalSolver {
 public:
  using RivalSolver::RivalSolver;

  /// See HermiteSolver::first_root.
  [[nodiscard]] std::optional<double> first_root(Node a, const Node& last, bool a_is_root, bool any) {
    if (any && last.value > last.noise) return last.t;
    const double share = kLeastShare * (last.t - a.t);
    double least = std::max(a_is_root ? 0 : lengths_.shortest.by_tolerance, share);
    double ahead = last.t - a.t;
    for (int i = 0; i < kMostSteps && !steps_.is_spent(); ++i) {
      if (!a_is_root && a.value > a.noise) return a.t;
      least = std::max(least, 0x1p-51 * std::abs(a.t));  // a step of at least one double
      ahead = std::min(std::max(ahead, 2 * least), last.t - a.t);
      if (!(a.t + ahead > a.t)) return std::nullopt;
      const FieldRange bend = bends(a.t, a.t + ahead);
      const double free = a_is_root ? back_at(a, bend.high) : first_at(a, bend.high);
      double step = std::min(free, ahead);
      bool is_certain = free >= ahead;
      if (!is_certain && !a_is_root && a.slope - a.slope_noise + std::min(bend.low, 0.0) * ahead > 0) {
        step = ahead;
        is_certain = true;
      } else if (!(step >= least)) {
        step = std::min(least, ahead);
        give_up_step();
        least *= 2;
      }
      const Node b = a.t + step < last.t ? node(a.t + step) : last;
      if (b.value > b.noise && free < b.t - a.t) return any || a_is_root ? b.t : newton(a, b);
      if (b.t >= last.t) return std::nullopt;
      ahead = 2 * step;
      a = b;
      if (a_is_root) least = std::max(least, lengths_.shortest.by_tolerance);
      a_is_root = false;
    }
    give_up_step();
    return std::nullopt;
  }

 private:
  /// The x at which the upper parabola first comes above the rounding of F. A value within the rounding is no crossing.
  [[nodiscard]] static double first_at(const Node& a, double bend) {
    const double below = a.noise - a.value, discriminant = a.slope * a.slope + 2 * bend * below;
    if (!(discriminant >= 0)) return std::isnan(discriminant) ? 0 : std::numeric_limits<double>::infinity();
    const double root = std::sqrt(discriminant);
    if (a.slope > 0) return 2 * below / (a.slope + root);
    return bend > 0 ? (root - a.slope) / bend : std::numeric_limits<double>::infinity();
  }
  /// The x at which the upper parabola comes back to the surface that it starts on.
  [[nodiscard]] static double back_at(const Node& a, double bend) {
    if (!(a.slope < 0)) return 0;
    return bend <= 0 ? std::numeric_limits<double>::infinity() : -2 * a.slope / bend;
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
