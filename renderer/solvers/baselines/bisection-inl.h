// The search of the baselines that halve an interval until they know whether it holds a root. `Solver::judge` decides
// and `Solver::refine` finds the root. The nearest part comes first. An interval that is too short to be halved is
// decided by its ends, and counted as uncertified.
#if defined(ISL_RENDERER_SOLVERS_BASELINES_BISECTION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_BASELINES_BISECTION_INL_H_
#undef ISL_RENDERER_SOLVERS_BASELINES_BISECTION_INL_H_
#else
#define ISL_RENDERER_SOLVERS_BASELINES_BISECTION_INL_H_
#endif

#include "renderer/solvers/baselines/rival_solver-inl.h"

#include <algorithm>
#include <optional>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

enum class Verdict {
  none,     ///< no root on the interval, other than a known one at its start
  rises,    ///< F rises all along the interval
  unclear,  ///< not decided: the interval is halved
};

/// `Solver` has
///   Verdict judge(a, b, a_is_root, middle)   on the interval between two nodes; may return the node in its middle
///   double refine(a, b)                      the root between a.value ≤ 0 < b.value
template <class Solver>
class Bisection : public RivalSolver {
 public:
  using RivalSolver::RivalSolver;

  /// See HermiteSolver::first_root.
  [[nodiscard]] std::optional<double> first_root(Node a, const Node& last, bool a_is_root, bool any) {
    // A ray that ends on the other side has crossed, wherever that was.
    if (any && last.value > last.noise) return last.t;
    const double shortest_at_start = kLeastShare * (last.t - a.t);
    const double shortest = std::max(lengths_.shortest.by_tolerance, shortest_at_start);
    Node ends[kMostHalvings + 1];
    int top = 0, steps = 0;
    ends[0] = last;
    while (top >= 0) {
      if (!a_is_root && a.value > a.noise) return a.t;
      const Node b = ends[top];
      const bool crossed = b.value > b.noise;
      std::optional<Node> middle;
      Verdict verdict = self().judge(a, b, a_is_root, middle);
      if (verdict == Verdict::unclear) {
        const double h = b.t - a.t, t = middle_of(a, b);
        const bool may_halve =
            h > (a_is_root ? shortest_at_start : shortest) && top < kMostHalvings && t > a.t && t < b.t;
        if (may_halve && ++steps <= kMostSteps && !steps_.is_spent()) {
          ends[++top] = middle ? *middle : node(t);
          continue;
        }
        give_up_step();
        verdict = crossed ? Verdict::rises : Verdict::none;
      }
      // With a known root at the start, this is another one, too close to tell apart from it.
      if (verdict == Verdict::rises && crossed) return any || a_is_root ? b.t : self().refine(a, b);
      a = b;
      a_is_root = false;
      --top;
    }
    return std::nullopt;
  }

 protected:
  [[nodiscard]] static double middle_of(const Node& a, const Node& b) { return a.t + 0.5 * (b.t - a.t); }

 private:
  [[nodiscard]] Solver& self() { return static_cast<Solver&>(*this); }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
