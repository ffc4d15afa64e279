// What the rival solvers have in common, so that only their way of looking for a root differs: the field seen from the
// ray's side, at places and on intervals, their lengths, and the two ways of closing in on a root that a change of sign
// brackets. Each rival is a class like HermiteSolver, which the driver (cell_search-inl.h) asks for the first root in a
// cell.
//
// Evaluations are counted where F is: at a place, and on an interval of a ray by interval arithmetic. Bounds of
// derivatives are not, as little as the product's.
//
// The certified ones (interval, lg, inclusion) close in to the rounding of F and know the root that a ray starts on, as
// the product does. The others stop at the tolerance, and leave a surface as their papers' programs do, by a first
// step.
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

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// Lengths in units of t.
struct RivalLengths {
  Shortest shortest;
  const SolverSettings* settings;
  double distance;  ///< from the eye, where t = 0
};

/// The same fields, compiled once for all rivals instead of into every search.
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

  RivalSolver(const Fields& fields, double side, const Lengths& lengths, TraceCounters& counters)
      : fields_(fields), side_(side), lengths_(lengths), counters_(counters) {}

  void turn_inside() { side_ = -1; }

  [[nodiscard]] Node node(double t) {
    const FieldAt f = fields_.at(t);
    counters_.field_evaluations += fields_.field_count();
    return {t, side_ * f.value, side_ * f.slope, fields_.noise(t, f), fields_.slope_noise(f)};
  }

 protected:
  /// A search halves no interval more often than this: 2⁻⁶⁴ of any is below the spacing of doubles.
  static constexpr int kMostHalvings = 64;
  /// Intervals or steps that one search may take, so that a ray that hugs a surface ends: far more than any other one
  /// takes.
  static constexpr int kMostSteps = 1 << 16;

  /// Of a root near t.
  [[nodiscard]] double tolerance(double t) const { return lengths_.settings->at(lengths_.distance + t); }
  /// STEP of those that march, near t.
  [[nodiscard]] double step(double t) const { return lengths_.settings->step_at(lengths_.distance + t); }

  /// F on the interval, by interval arithmetic.
  [[nodiscard]] FieldRange values(double t0, double t1) {
    counters_.field_evaluations += fields_.field_count();
    return seen(fields_.range(t0, t1));
  }
  [[nodiscard]] FieldRange slopes(double t0, double t1) const { return seen(fields_.slope_range(t0, t1)); }
  [[nodiscard]] FieldRange bends(double t0, double t1) const { return seen(fields_.bend_range(t0, t1)); }
  [[nodiscard]] static double size(const FieldRange& r) { return std::max(std::abs(r.low), std::abs(r.high)); }

  /// Newton's method, kept in the bracket a.value ≤ 0 < b.value by halving it, down to the rounding of F.
  [[nodiscard]] double newton(Node a, Node b) {
    double t = a.t + 0.5 * (b.t - a.t);
    for (int i = 0; i < 2 * kMostHalvings; ++i) {
      if (!(t > a.t && t < b.t)) return b.t;
      const Node n = node(t);
      const double next = t - n.value / n.slope;
      if (std::abs(n.value) <= n.noise) return next > a.t && next < b.t ? next : t;
      (n.value > 0 ? b : a) = n;
      t = next > a.t && next < b.t ? next : a.t + 0.5 * (b.t - a.t);
    }
    return b.t;
  }

  /// Regula falsi in the bracket a.value ≤ 0 < b.value, of the kind that halves the value of an end that stays (Dowell
  /// and Jarratt 1971), until the bracket or the last step is within the tolerance, or F within its rounding.
  [[nodiscard]] double regula_falsi(Node a, Node b) {
    const double enough = tolerance(a.t);
    double last = b.t;
    int stays = 0;  // +1: b did, −1: a did
    for (int i = 0; i < 2 * kMostHalvings && b.t - a.t > enough; ++i) {
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
  TraceCounters& counters_;

 private:
  [[nodiscard]] FieldRange seen(const FieldRange& f) const { return side_ > 0 ? f : FieldRange{-f.high, -f.low}; }
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
