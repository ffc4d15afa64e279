// Searches a cell in which the field is the greatest of several sums (CellKind::choice). Each sum is solved as if it
// were alone, by the solver that finds roots in other cells, so that the edges of the maximum are never met.
//
// From outside, the ray crosses where the first of the sums does. From inside, it follows one sum that is above the
// threshold to where that one leaves, then goes on with another that is still above there; if there is none, it
// crosses. A ray that starts on the surface starts on the sums that are the greatest there, up to rounding; it is
// inside if it enters any of them.
#if defined(ISL_RENDERER_SOLVERS_CELLS_MAXIMUM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_CELLS_MAXIMUM_INL_H_
#undef ISL_RENDERER_SOLVERS_CELLS_MAXIMUM_INL_H_
#else
#define ISL_RENDERER_SOLVERS_CELLS_MAXIMUM_INL_H_
#endif

#include "renderer/compiled/compiled_scene.h"
#include "renderer/fields/ray/ray_lanes-inl.h"
#include "renderer/grid/grid.h"
#include "renderer/rays/trace_counters.h"
#include "renderer/solvers/cells/extended_search.h"
#include "renderer/solvers/cells/node-inl.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// The side of the surface that a ray is on.
enum class Side { unknown, outside, inside };

/// True if a ray that starts on the surface of `fields` goes in. The slope there decides or, if it is lost in rounding
/// (a tangent ray), the curvature.
[[nodiscard]] inline bool leaves_inwards(const RayLanes& fields, const Node& start) {
  if (std::abs(start.slope) > start.slope_noise) return start.slope > 0;
  return fields.curvature(start.t) > 0;
}

/// A stretch of a ray in a cell.
struct MaximumQuery {
  Vec3 origin, direction;
  double t0, t1;
  bool starts_here;  ///< the ray starts on the surface, at t0
  bool any;
};

template <class Solver>
class MaximumSolver {
 public:
  MaximumSolver(const CompiledBlob& blob, const Cell& cell, const MaximumQuery& query,
                const typename Solver::Lengths& lengths, typename Solver::Fields& fields, RaySteps& steps,
                TraceCounters& counters)
      : blob_(blob),
        cell_(cell),
        query_(query),
        lengths_(lengths),
        fields_(fields),
        steps_(steps),
        counters_(counters) {}

  /// The t in (t0, t1] at which the ray changes sides, or t0 if the ray is not on the given side there. Sets an unknown
  /// side.
  [[nodiscard]] std::optional<double> first_crossing(Side& side) {
    if (query_.starts_here) {
      greatest_at_start_ = greatest_at(query_.t0);
      side = Side::outside;
      for (std::uint32_t i = 0; i < cell_.count(); ++i) {
        if (is_on_surface(i) && leaves_inwards(fields_, node_of(i, query_.t0))) side = Side::inside;
      }
    } else if (side == Side::unknown) {
      side = inside_at(query_.t0) ? Side::inside : Side::outside;
    }
    return side == Side::inside ? leave() : enter();
  }

 private:
  struct Greatest {
    std::uint32_t index = 0;
    Node node{0, -std::numeric_limits<double>::infinity(), 0, 0, 0, 0};
  };

  void lay_out(std::uint32_t i) {
    const ItemList list = blob_.grid.list(cell_, i);
    fields_.set_up(blob_.components, blob_.grid.items.data() + list.first, list.count, query_.origin, query_.direction,
                   query_.t0, query_.t1);
  }
  /// The node of a sum at t. Leaves the sum's fields laid out.
  [[nodiscard]] Node node_of(std::uint32_t i, double t) {
    lay_out(i);
    return Solver(fields_, 1, lengths_, steps_, counters_).node(t);
  }
  [[nodiscard]] Greatest greatest_at(double t) {
    Greatest greatest;
    for (std::uint32_t i = 0; i < cell_.count(); ++i) {
      if (const Node node = node_of(i, t); node.value > greatest.node.value) greatest = {i, node};
    }
    return greatest;
  }
  /// A sum that is above the threshold at t, and not among those that have left there. One whose sign is lost in the
  /// rounding of double precision, as where large fields of both signs meet, is asked with more digits, but only if no
  /// other is above.
  [[nodiscard]] std::optional<std::uint32_t> inside_at(double t) {
    bool is_doubtful = false;
    for (std::uint32_t i = 0; i < cell_.count(); ++i) {
      if (has_left(i)) continue;
      const Node node = node_of(i, t);
      if (node.value > node.doubt) return i;
      if (node.value > -node.doubt) is_doubtful = true;
    }
    for (std::uint32_t i = 0; is_doubtful && i < cell_.count(); ++i) {
      if (has_left(i)) continue;
      const Node node = node_of(i, t);
      if (!(node.value > -node.doubt)) continue;
      const std::optional<bool> inside = is_inside(fields_.laid_out(), t, steps_);
      // A sum has just left the surface at this t. If another one falls here and no digits tell its sign, it leaves
      // within the same rounding of t.
      if (!inside && !left_.empty() && node.slope < -node.slope_noise) continue;
      if (!inside) ++counters_.undecided_steps;
      if (inside.value_or(node.value > node.noise)) return i;
    }
    return std::nullopt;
  }
  [[nodiscard]] bool has_left(std::uint32_t i) const { return std::ranges::find(left_, i) != left_.end(); }
  [[nodiscard]] bool is_outside_at(double t) {
    for (std::uint32_t i = 0; i < cell_.count(); ++i) {
      if (const Node node = node_of(i, t); !(node.value < -node.doubt)) return false;
    }
    return true;
  }
  /// True if the ray starts on the sum. Leaves the sum's fields laid out.
  [[nodiscard]] bool is_on_surface(std::uint32_t i) {
    if (!query_.starts_here) return false;
    const Node node = node_of(i, query_.t0), &top = greatest_at_start_.node;
    return node.value >= top.value - (node.noise + top.noise);
  }

  [[nodiscard]] std::optional<double> enter() {
    std::optional<double> nearest;
    double end = query_.t1;
    for (std::uint32_t i = 0; i < cell_.count(); ++i) {
      const bool is_start = is_on_surface(i);
      lay_out(i);
      if (fields_.upper_bound() < 0 && !is_start) continue;
      Solver solver(fields_, 1, lengths_, steps_, counters_);
      Node from = solver.node(query_.t0);
      if (is_start) from.value = 0;
      Node last = solver.node(end);
      const std::optional<double> t = solver.first_root(from, last, is_start, query_.any);
      if (!t) continue;
      nearest = t;
      if (query_.any) break;
      end = short_of(solver.node(*t));
      if (!(end > query_.t0)) break;
    }
    return nearest;
  }
  /// Where to end the search of further sums before a root: as far before it as rounding may have moved it. A sum that
  /// is nearly the same there would leave it undecided which of them crosses first, and it does not matter.
  [[nodiscard]] double short_of(const Node& root) const {
    constexpr double kMostOfStretch = 0x1p-26;  // near a tangent, where the slope says little
    const double moved = 4 * root.doubt / std::abs(root.slope);
    return root.t - std::min(moved, kMostOfStretch * (root.t - query_.t0));
  }

  [[nodiscard]] std::optional<double> leave() {
    // A ray that is outside in the end has left, wherever that was.
    if (query_.any && is_outside_at(query_.t1)) return query_.t1;
    double t = query_.t0;
    std::optional<std::uint32_t> followed = query_.starts_here ? first_entered() : inside_at(t);
    bool is_start = query_.starts_here;
    while (followed) {
      if (!steps_.take(cell_.count())) {
        ++counters_.undecided_steps;
        return t;
      }
      lay_out(*followed);
      Solver solver(fields_, -1, lengths_, steps_, counters_);
      Node from = solver.node(t);
      // More digits may have told that the ray is inside, where double precision says that it is not.
      from.value = is_start ? 0 : std::min(from.value, 0.0);
      Node last = solver.node(query_.t1);
      const std::optional<double> next = solver.first_root(from, last, is_start, false);
      if (!next) return std::nullopt;
      // A sum that leaves counts no more here: its rounding may be greater than all that the others are worth. Two sums
      // that leave within the rounding of the ray's places would hand the ray to each other by one unit in the last
      // place of t at a time.
      if (!(*next <= left_until_)) {
        left_.clear();
        left_until_ = *next + rounding_of_places(query_.origin, query_.direction, *next);
      }
      left_.push_back(*followed);
      t = *next;
      followed = inside_at(t);
      is_start = false;
    }
    return t;
  }
  [[nodiscard]] std::uint32_t first_entered() {
    std::uint32_t i = 0;
    while (!(is_on_surface(i) && leaves_inwards(fields_, node_of(i, query_.t0)))) ++i;
    return i;
  }

  const CompiledBlob& blob_;
  const Cell& cell_;
  const MaximumQuery& query_;
  const typename Solver::Lengths& lengths_;
  typename Solver::Fields& fields_;
  RaySteps& steps_;
  TraceCounters& counters_;
  Greatest greatest_at_start_;
  std::vector<std::uint32_t> left_;  ///< the sums that fell below the threshold where the ray has come to
  double left_until_ = -std::numeric_limits<double>::infinity();  ///< and the t up to which that counts as one place
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
