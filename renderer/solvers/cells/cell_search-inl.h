// Searches for a blob's surface along a ray: it takes the grid's cells in order and solves each by itself. `Solver`
// finds the first root in a cell. It is the product's solver (hermite-inl.h) or a baseline (rival_solver-inl.h), so
// that solvers differ in nothing else. The search knows which side of the surface the ray is on. A crossing is a change
// of that side, whether a cell's solver found it or two neighbours disagree by a rounding about a root on their common
// border. If the blob has half-spaces or sheets, the ray is also searched before and behind the grid.
#if defined(ISL_RENDERER_SOLVERS_CELLS_CELL_SEARCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_CELLS_CELL_SEARCH_INL_H_
#undef ISL_RENDERER_SOLVERS_CELLS_CELL_SEARCH_INL_H_
#else
#define ISL_RENDERER_SOLVERS_CELLS_CELL_SEARCH_INL_H_
#endif

#include "renderer/compiled/compiled_scene.h"
#include "renderer/fields/ray/ray_lanes-inl.h"
#include "renderer/grid/grid_walk-inl.h"
#include "renderer/rays/blob_ray.h"
#include "renderer/rays/ray_steps.h"
#include "renderer/rays/trace_counters.h"
#include "renderer/solvers/cells/extended_search.h"
#include "renderer/solvers/cells/maximum-inl.h"
#include "renderer/solvers/cells/node-inl.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// A leaf or inside cell that a ray meets, and the stretch of the ray in it.
struct CellStretch {
  std::uint32_t index;
  Cell cell;
  double enter, leave;
};

template <class Solver>
class CellSearch {
 public:
  CellSearch(const CompiledBlob& blob, const SolverSettings& settings, LaneMemory& memory, TraceCounters& counters)
      : blob_(blob), settings_(settings), fields_(memory), counters_(counters) {}

  [[nodiscard]] BlobHit first_hit(const BlobRay& ray) {
    const Grid& grid = blob_.grid;
    begin(ray);
    const BoxSpan span = span_in_grid(grid, ray);
    const bool meets_grid = span.enter < span.leave;
    if (grid.beyond == scene::kNone) {
      if (meets_grid) in_grid(span);
    } else if (!meets_grid) {
      beyond_grid(0, ray.t_max);
    } else if (!beyond_grid(0, span.enter) && !in_grid(span)) {
      beyond_grid(span.leave, ray.t_max);
    }
    return hit();
  }

  /// The stretch of a ray in the grid's core, empty if the ray misses it. For a ray that begins in the grid's box it
  /// begins with the ray, whose origin then does not move: a ray that is taken up again shortly before a surface, or on
  /// it, must be the same line.
  [[nodiscard]] static HWY_INLINE BoxSpan span_in_grid(const Grid& grid, const BlobRay& ray) {
    if (!(grid.cell_size > 0)) return {1, 0};
    BoxSpan span = clip_to_box(grid.core, ray.origin, ray.direction, 0, ray.t_max);
    if (span.enter < span.leave && grid.box.intersects(ray.origin)) span.enter = 0;
    return span;
  }

  // The search step by step, for callers that walk the grid themselves (packet_search-inl.h). Precondition: nothing
  // lies beyond the grid. Call begin, enter_grid with the t at which the ray meets the grid, then solve_from for cells
  // in order, until a crossing is found.

  /// Takes up the ray, which must outlive the search.
  void begin(const BlobRay& ray) {
    ray_ = &ray;
    side_ = Side::unknown;
    hit_ = {};
    steps_ = RaySteps(settings_.ray_steps, settings_.stop);
    undecided_from_ = start_doubt_ = std::numeric_limits<double>::infinity();
  }
  /// Moves to the start of the stretch in the grid: from here on t counts from there.
  void enter_grid(double base) {
    take_up(base);
    if (blob_.grid.beyond == scene::kNone && base_ > 0) side_ = Side::outside;
  }
  /// True if the ray, which comes to the cell on this side, crosses in it. `may_be_on_surface`: it comes from the
  /// surface that it starts on, and nothing has told yet that it has left it.
  [[nodiscard]] bool solve_from(Side side, bool may_be_on_surface, const CellStretch& stretch) {
    side_ = side;
    is_on_surface_ = may_be_on_surface;
    if (stretch.enter != node_.t) is_node_valid_ = false;
    return solve_in(stretch);
  }
  [[nodiscard]] Side side() const { return side_; }
  /// True if the ray has left the surface that it starts on by no more than rounding.
  [[nodiscard]] bool is_on_surface() const { return is_on_surface_; }
  /// True if rounding shows the wrong side at the end of the last cell, and more digits have proved the right one. The
  /// next cell cannot see it.
  [[nodiscard]] bool is_corrected() const { return is_node_valid_ && node_.value == 0; }
  [[nodiscard]] const BlobHit& hit() {
    if (hit_.is_miss()) hit_.from_inside = side_ == Side::inside;
    hit_.undecided_from = undecided_from_;
    return hit_;
  }

 private:
  /// Moves the origin to t = `base`, where the ray meets the grid, so that the fields see small numbers even if the
  /// grid is far away; t counts from there.
  void take_up(double base) {
    base_ = base;
    origin_ = ray_->origin + ray_->direction * base;
    direction_ = ray_->direction;
    starts_on_surface_ = is_on_surface_ = ray_->starts_on_surface && base == 0;
    reached_ = 0;
    last_cell_ = scene::kNone;
    is_node_valid_ = false;
    const Shortest shortest{kShortestOfTolerance * settings_.at(ray_->path_length + base), ray_->takes_faint_dips,
                            settings_.digits};
    lengths_ = Solver::lengths(shortest, settings_, ray_->path_length + base);
  }

  /// True if the ray crosses the surface in the grid's box.
  bool in_grid(const BoxSpan& span) {
    enter_grid(span.enter);
    walk(blob_.grid, origin_, direction_, 0, span.leave - base_,
         [&](std::uint32_t index, const Cell& cell, double t0, double t1) HWY_ATTR {
           return visit({index, cell, t0, t1});
         });
    return !hit_.is_miss();
  }

  /// True if the ray crosses the surface where only half-spaces and sheets reach. Between the planes where their fields
  /// begin and end the sum is smooth, and behind the last plane it is constant: one more stretch, of any length, shows
  /// its value there.
  bool beyond_grid(double begin, double end) {
    if (!(begin < end)) return false;
    const Grid& grid = blob_.grid;
    const Cell& cell = grid.cells[grid.beyond];
    take_up(begin);
    const double length = end - begin;
    double t = 0;
    while (t < length) {
      double next = std::numeric_limits<double>::infinity();
      for_each_endless([&](const auto& shape, double reach) {
        const double x = (origin_ - shape.at).dot(shape.normal), dx = direction_.dot(shape.normal);
        for (const double border : shape.kBorders) {
          if (const double at = (border * reach - x) / dx; at > t) next = std::min(next, at);
        }
      });
      const bool is_constant = std::isinf(next);
      if (visit({grid.beyond, cell, t, std::min(length, is_constant ? t + std::max(1.0, t) : next)})) return true;
      if (is_constant) return false;
      t = next;
    }
    return false;
  }
  /// Calls use(shape, reach), where reach is how far the shape's field extends before its plane.
  template <class Use>
  void for_each_endless(const Use& use) const {
    const ComponentTable& table = blob_.components;
    for (const std::uint32_t item : blob_.grid.endless_items) {
      const FieldGroup& group = table.group_of(item);
      table.with_endless(group, item,
                         [&](const auto& shape) { use(shape, shape.radius * ComponentTable::support_root(group)); });
    }
  }

  /// Records that the ray changes sides at t, on the border of `cell` or in it.
  bool cross(double t, std::uint32_t cell) {
    hit_ = {.t = base_ + t, .cell = cell, .from_inside = side_ == Side::inside};
    return true;
  }

  /// The cell whose list shades a crossing that falls between cells.
  [[nodiscard]] std::uint32_t last_solved_or(std::uint32_t index) const {
    return last_cell_ == scene::kNone ? index : last_cell_;
  }

  /// Lets the ray come to a leaf or inside cell. True if it crosses in the cell or on the way.
  bool visit(const CellStretch& stretch) {
    const auto& [index, cell, t0, t1] = stretch;
    ++counters_.cells;
    if (t0 > reached_) {
      // Between leaf cells there are only cells that are certainly outside.
      if (side_ == Side::inside) return cross(reached_, last_solved_or(index));
      side_ = Side::outside;
      is_node_valid_ = is_on_surface_ = false;
    }
    reached_ = t1;
    if (cell.kind() == CellKind::inside) {
      if (side_ == Side::outside) return cross(t0, last_solved_or(index));
      side_ = Side::inside;
      is_node_valid_ = is_on_surface_ = false;
      return false;
    }
    last_cell_ = index;
    return solve_in(stretch);
  }

  /// The same of a cell in which the search has something to find.
  bool solve_in(const CellStretch& stretch) {
    const std::uint64_t undecided_before = counters_.undecided_steps;
    const bool was_spent = steps_.is_spent(), was_in_vain = is_in_vain();
    const bool crosses = find_in(stretch);
    counters_.most_ray_steps = std::max(counters_.most_ray_steps, steps_.taken());
    if (counters_.undecided_steps != undecided_before)
      undecided_from_ = std::min(undecided_from_, base_ + stretch.enter);
    if (steps_.is_spent() && !was_spent) ++counters_.spent_rays;
    if (is_in_vain() && !was_in_vain) ++counters_.vain_rays;
    return crosses;
  }

  /// True if the ray has taken many steps and is undecided all the same.
  [[nodiscard]] bool is_in_vain() const {
    return undecided_from_ < std::numeric_limits<double>::infinity() && steps_.are_many();
  }

  /// True if the ray crosses in the cell.
  bool find_in(const CellStretch& stretch) {
    const auto& [index, cell, t0, t1] = stretch;
    const bool starts_here = starts_on_surface_ && t0 == 0;
    if (cell.kind() == CellKind::leaf) return solve(index, cell, t0, t1, starts_here);
    is_node_valid_ = is_on_surface_ = false;
    const MaximumQuery query{origin_, direction_, t0, t1, starts_here, ray_->any};
    const std::optional<double> t =
        MaximumSolver<Solver>(blob_, cell, query, lengths_, fields_, steps_, counters_).first_crossing(side_);
    return t && cross(*t, index);
  }

  bool solve(std::uint32_t index, const Cell& cell, double t0, double t1, bool starts_here) {
    fields_.set_up(blob_.components, blob_.grid.items.data() + cell.first, cell.count(), origin_, direction_, t0, t1);
    if (fields_.upper_bound() < 0 && !starts_here) {
      is_node_valid_ = is_on_surface_ = false;
      if (side_ == Side::inside) return cross(t0, index);
      side_ = Side::outside;
      return false;
    }
    Solver solver(fields_, side_ == Side::inside ? -1.0 : 1.0, lengths_, steps_, counters_);
    Node a = is_node_valid_ ? node_ : solver.node(t0);
    if (side_ == Side::unknown) {
      side_ = (starts_here ? leaves_inwards(fields_, a) : starts_inside(a)) ? Side::inside : Side::outside;
      if (side_ == Side::inside) {
        a.value = -a.value;
        a.slope = -a.slope;
        solver.turn_inside();
      }
    }
    // A ray that has left its surface by no more than rounding is on it as far as anybody knows, also in the next cell.
    if (starts_here) start_doubt_ = a.doubt;
    const bool is_root = starts_here || (is_on_surface_ && is_near_surface(a));
    if (is_root) a.value = 0;
    Node b = solver.node(t1);
    if (const std::optional<double> t = solver.first_root(a, b, is_root, ray_->any)) return cross(*t, index);
    node_ = b;
    is_node_valid_ = true;
    is_on_surface_ = is_root && is_near_surface(b);
    return false;
  }
  /// True if F is no farther from 0 than rounding explains, here and where the ray starts: deep in a hard component it
  /// is known to few digits, but the ray has left the surface.
  [[nodiscard]] bool is_near_surface(const Node& n) const { return n.value > -std::min(n.doubt, start_doubt_); }

  [[nodiscard]] bool starts_inside(const Node& a) {
    if (std::abs(a.value) > a.doubt) return a.value > 0;
    if (const std::optional<bool> inside = is_inside(fields_.laid_out(), a.t, steps_)) return *inside;
    ++counters_.undecided_steps;
    return a.value > a.noise;
  }

  const CompiledBlob& blob_;
  const SolverSettings& settings_;
  typename Solver::Fields fields_;
  TraceCounters& counters_;

  const BlobRay* ray_ = nullptr;
  RaySteps steps_;
  Vec3 origin_, direction_;
  double base_ = 0;
  typename Solver::Lengths lengths_{};
  bool starts_on_surface_ = false;
  Side side_ = Side::unknown;
  double reached_ = 0;                      ///< t up to which the ray has been followed
  std::uint32_t last_cell_ = scene::kNone;  ///< the last cell solved; its list holds every component that matters at
                                            ///< `reached_`
  bool is_node_valid_ = false;
  Node node_{};                 ///< the node at reached_, seen from the ray's side
  bool is_on_surface_ = false;  ///< at reached_ the ray may still be on the surface that it starts on
  double start_doubt_ = std::numeric_limits<double>::infinity();  ///< Node::doubt there, if it is known
  BlobHit hit_;
  double undecided_from_ = std::numeric_limits<double>::infinity();
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
