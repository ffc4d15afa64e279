// The part that all baselines share, so that only their way of looking for a root differs: the field seen from the
// ray's side, at points and on intervals, its lengths, and the two ways of closing in on a root that a change of sign
// brackets. Each baseline is a class like HermiteSolver, which the driver (cell_search-inl.h) asks for the first root
// in a cell.
//
// Evaluations of F are counted: at a point, and on an interval of a ray by interval arithmetic. Bounds of derivatives
// are not counted, neither here nor in the product's solver.
//
// The certified baselines (interval, lg, inclusion) close in to the rounding of F and know the root that a ray starts
// on, as the product does. The others stop at the tolerance, and leave a surface by a first step, as the programs of
// their papers do.
#if defined(ISL_RENDERER_SOLVERS_BASELINES_RIVAL_SOLVER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_BASELINES_RIVAL_SOLVER_INL_H_
#undef ISL_RENDERER_SOLVERS_BASELINES_RIVAL_SOLVER_INL_H_
#else
#define ISL_RENDERER_SOLVERS_BASELINES_RIVAL_SOLVER_INL_H_
#endif

#include "renderer/fields/ray/ray_lanes-inl.h"
#include "renderer/rays/blob_ray.h"
#include "renderer/rays/trace_counters.h"
#include "renderer/solvers/cells/node-inl.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// Lengths in units of t.
struct RivalLengths {
  Shortest shortest;
  const SolverSettings* settings;
  double distance;  ///< distance of t = 0 from the eye
};

/// The same fields, compiled once for all baselines instead of inlined into every search.
class RivalLanes : public RayLanes {
 public:
  using RayLanes::RayLanes;

  HWY_NOINLINE void set_up(const ComponentTable& table, const std::uint32_t* items, std::uint32_t count,
                           const Vec3& origin, const Vec3& direction, double t0, double t1) {
    RayLanes::set_up(table, items, count, origin, direction, t0, t1);
  }
  [[nodiscard]] HWY_NOINLINE FieldAt at(double t) const { return RayLanes::at(t); }
};

class RivalSolver {
 public:
  using Fields = RivalLanes;
  using Lengths = RivalLengths;

  [[nodiscard]] static Lengths lengths(const Shortest& shortest, const SolverSettings& settings, double distance) {
    return {shortest, &settings, distance};
  }

  RivalSolver(const Fields& fields, double side, const Lengths& lengths, RaySteps& steps, TraceCounters& counters)
      : fields_(fields), side_(side), lengths_(lengths), steps_(steps), counters_(counters) {}

  void turn_inside() { side_ = -1; }

  [[nodiscard]] Node node(double t) {
    const FieldAt f = fields_.at(t);
    count_evaluation();
    const double noise = fields_.noise(t, f);
    return {t, side_ * f.value, side_ * f.slope, noise, fields_.slope_noise(f), fields_.doubt(noise, f)};
  }

 protected:
  /// The most intervals or steps of one search, so that it ends for a ray that hugs a surface. Any other ray takes far
  /// fewer. A search also ends where the ray's own steps are spent.
  static constexpr int kMostSteps = 1 << 16;

  /// True once the steps of the ray are spent: the rest of the search is given up, and counted as undecided.
  [[nodiscard]] bool gives_up() {
    if (steps_.is_spent()) give_up_step();
    return steps_.is_spent();
  }
  /// Counts an interval that is left undecided.
  void give_up_step() {
    ++counters_.uncertified_steps;
    ++counters_.undecided_steps;
  }

  /// The tolerance of a root near t.
  [[nodiscard]] double tolerance(double t) const { return lengths_.settings->at(lengths_.distance + t); }
  /// The STEP of methods that march, near t.
  [[nodiscard]] double step(double t) const { return lengths_.settings->step_at(lengths_.distance + t); }

  /// The range of F on the interval, by interval arithmetic.
  [[nodiscard]] FieldRange values(double t0, double t1) {
    count_evaluation();
    return seen(fields_.range(t0, t1));
  }
  [[nodiscard]] FieldRange slopes(double t0, double t1) const { return seen(fields_.slope_range(t0, t1)); }
  [[nodiscard]] FieldRange bends(double t0, double t1) const { return seen(fields_.bend_range(t0, t1)); }
  [[nodiscard]] static double size(const FieldRange& r) { return std::max(std::abs(r.low), std::abs(r.high)); }

  /// Newton's method in the bracket a.value ≤ 0 < b.value, down to the rounding of F. A step that leaves the bracket,
  /// or that has not shrunk by half, is replaced by a halving.
  [[nodiscard]] double newton(Node a, Node b) {
    double t = a.t + 0.5 * (b.t - a.t), last = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kMostHalvings; ++i) {
      if (!(t > a.t && t < b.t)) return b.t;
      const Node n = node(t);
      const double next = t - n.value / n.slope, size = std::abs(next - t);
      if (std::abs(n.value) <= n.noise) return next > a.t && next < b.t ? next : t;
      (n.value > 0 ? b : a) = n;
      const bool shrinks = next > a.t && next < b.t && size <= 0.5 * last;
      last = shrinks ? size : std::numeric_limits<double>::infinity();
      t = shrinks ? next : a.t + 0.5 * (b.t - a.t);
    }
    return b.t;
  }

  /// Regula falsi in the bracket a.value ≤ 0 < b.value. The value at an end that stays is halved (Dowell and Jarratt
  /// 1971). It ends when the bracket or the last step is within the tolerance, or F within its rounding.
  [[nodiscard]] double regula_falsi(Node a, Node b) {
    const double enough = tolerance(a.t);
    double last = b.t;
    int stays = 0;  // which end stayed in the last step: +1 for b, −1 for a
    for (int i = 0; i < kMostHalvings && b.t - a.t > enough; ++i) {
      double t = a.t + (b.t - a.t) * (a.value / (a.value - b.value));
      if (!(t > a.t && t < b.t)) t = a.t + 0.5 * (b.t - a.t);
      if (!(t > a.t && t < b.t)) break;
      const Node n = node(t);
      const bool is_close = std::abs(t - last) <= enough;
      last = t;
      if (is_close || std::abs(n.value) <= n.noise) break;
      if (n.value > 0) {
        b = n;
        if (stays < 0) a.value *= 0.5;
        stays = -1;
      } else {
        a = n;
        if (stays > 0) b.value *= 0.5;
        stays = 1;
      }
    }
    return last;
  }

  const Fields& fields_;
  double side_;
  Lengths lengths_;
  RaySteps& steps_;
  TraceCounters& counters_;

 private:
  void count_evaluation() {
    counters_.field_evaluations += fields_.field_count();
    static_cast<void>(steps_.take(fields_.steps_of_interval()));
  }
  [[nodiscard]] FieldRange seen(const FieldRange& f) const { return side_ > 0 ? f : FieldRange{-f.high, -f.low}; }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
