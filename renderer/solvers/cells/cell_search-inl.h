// The search for a blob's surface along a ray: the grid's cells in order, each solved by itself. `Solver` finds the first root in a
// cell: the product's (hermite-inl.h) or a rival (rival_solver-inl.h), so that solvers differ in nothing else.
// The ray carries which side of the surface it is on; a crossing is a change of that side, whether a cell's solver found it or
// two neighbours disagree by a rounding about a root on their common border. Where the blob has half-spaces or sheets, the ray is
// also searched before and behind the grid.
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
#include "renderer/rays/trace_counters.h"
#include "renderer/solvers/cells/maximum-inl.h"
#include "renderer/solvers/cells/node-inl.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// A leaf or inside cell on a ray's way, and the stretch of the ray in it.
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
    const BoxSpan span = begin(ray);
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

  // Step by step, for those who walk themselves (packet_search-inl.h). Only where nothing lies beyond the grid:
  //   begin, enter_grid, then arrive for each cell in order, and what it asks for, until a crossing is found.

  /// Takes up the ray, which must stay where it is. The stretch in the grid's box, empty where it does not meet it.
  [[nodiscard]] BoxSpan begin(const BlobRay& ray) {
    ray_ = &ray;
    side_ = Side::unknown;
    hit_ = {};
    if (!(blob_.grid.cell_size > 0)) return {1, 0};
    return clip_to_box(blob_.grid.box, ray.origin, ray.direction, 0, ray.t_max);
  }
  /// From here on t counts from base(), and the ray begins at origin().
  void enter_grid(const BoxSpan& span) {
    take_up(span.enter, blob_.grid.box.size().length());
    if (blob_.grid.beyond == scene::kNone && base_ > 0) side_ = Side::outside;
  }
  [[nodiscard]] const Vec3& origin() const { return origin_; }
  [[nodiscard]] double base() const { return base_; }
  [[nodiscard]] const typename Solver::Lengths& lengths() const { return lengths_; }

  /// What there is to do in a cell that the ray has come to.
  enum class Arrival {
    crosses,         ///< nothing: the ray has changed sides on the way, and the search is over
    passes,          ///< nothing
    candidate_leaf,  ///< a root may be in it, of a ray that comes from outside
    other_candidate  ///< there is more to it: solve_in
  };
  [[nodiscard]] Arrival arrive(const CellStretch& stretch) {
    const auto& [index, cell, t0, t1] = stretch;
    ++counters_.cells;
    if (t0 > reached_ || !is_node_valid_) {
      // Between leaf cells lie only cells certainly outside.
      if (t0 > reached_) {
        if (side_ == Side::inside) return crosses(reached_, last_solved_or(index));
        side_ = Side::outside;
      }
      is_node_valid_ = false;
    }
    if (cell.kind() == CellKind::inside) {
      if (side_ == Side::outside) return crosses(t0, last_solved_or(index));
      side_ = Side::inside;
      is_node_valid_ = false;
      reached_ = t1;
      return Arrival::passes;
    }
    last_cell_ = index;
    reached_ = t1;
    const bool is_plain = cell.kind() == CellKind::leaf && side_ == Side::outside && !(starts_on_surface_ && t0 == 0);
    return is_plain ? Arrival::candidate_leaf : Arrival::other_candidate;
  }
  /// Whether the ray crosses in a cell that it has arrived at.
  [[nodiscard]] bool solve_in(const CellStretch& stretch) {
    const auto& [index, cell, t0, t1] = stretch;
    const bool starts_here = starts_on_surface_ && t0 == 0;
    if (cell.kind() == CellKind::leaf) return solve(index, cell, t0, t1, starts_here);
    is_node_valid_ = false;
    const MaximumQuery query{origin_, direction_, t0, t1, starts_here, ray_->any};
    const std::optional<double> t =
        MaximumSolver<Solver>(blob_, cell, query, lengths_, fields_, counters_).first_crossing(side_);
    return t && cross(*t, index);
  }
  /// What has been found out otherwise of a cell that the ray has arrived at: it stays on its side to the end, or crosses at t.
  void set_passed() { is_node_valid_ = false; }
  void set_crossing(double t) { cross(t, last_cell_); }

  [[nodiscard]] const BlobHit& hit() {
    if (hit_.is_miss()) hit_.from_inside = side_ == Side::inside;
    return hit_;
  }

 private:
  /// From far away the ray is taken up again where it meets the grid, so that the fields see small numbers: t counts from
  /// `base`. `extent`: the size of what is met there.
  void take_up(double base, double extent) {
    base_ = base;
    origin_ = ray_->origin + ray_->direction * base;
    direction_ = ray_->direction;
    starts_on_surface_ = ray_->starts_on_surface && base == 0;
    reached_ = 0;
    last_cell_ = scene::kNone;
    is_node_valid_ = false;
    // Certification may stop at a thousandth of the tolerance, and must at 2⁻⁴⁰ of the blob.
    Shortest shortest;
    shortest.by_rounding = 0x1p-40 * extent / direction_.length();
    shortest.by_tolerance = std::max(shortest.by_rounding, 1e-3 * settings_.at(ray_->path_length + base));
    lengths_ = Solver::lengths(shortest, settings_, ray_->path_length + base);
  }

  /// Whether the ray crosses the surface in the grid's box.
  bool in_grid(const BoxSpan& span) {
    enter_grid(span);
    walk(blob_.grid, origin_, direction_, 0, span.leave - base_,
         [&](std::uint32_t index, const Cell& cell, double t0, double t1) HWY_ATTR {
           return visit({index, cell, t0, t1});
         });
    return !hit_.is_miss();
  }

  /// The same where half-spaces and sheets are alone. Between the planes where they begin and end the field is smooth, and
  /// behind the last of them it is constant: one stretch more, of any length, shows what it is there.
  bool beyond_grid(double begin, double end) {
    if (!(begin < end)) return false;
    const Grid& grid = blob_.grid;
    const Cell& cell = grid.cells[grid.beyond];
    double extent = std::numeric_limits<double>::infinity();
    for_each_endless([&](const auto& shape, double) { extent = std::min(extent, shape.radius); });
    take_up(begin, extent);
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
  /// Calls use(shape, how far its field reaches before its plane).
  template <class Use>
  void for_each_endless(const Use& use) const {
    const ComponentTable& table = blob_.components;
    for (const std::uint32_t item : blob_.grid.endless_items) {
      const FieldGroup& group = table.group_of(item);
      table.with_endless(group, item, [&](const auto& shape) { use(shape, shape.radius * ComponentTable::support_root(group)); });
    }
  }

  /// The ray changes sides at t, on the border of `cell` or in it.
  bool cross(double t, std::uint32_t cell) {
    hit_ = {base_ + t, cell, side_ == Side::inside};
    return true;
  }

  /// The cell whose list to shade with where a crossing falls between cells.
  [[nodiscard]] std::uint32_t last_solved_or(std::uint32_t index) const { return last_cell_ == scene::kNone ? index : last_cell_; }

  Arrival crosses(double t, std::uint32_t cell) {
    cross(t, cell);
    return Arrival::crosses;
  }

  bool visit(const CellStretch& stretch) {
    switch (arrive(stretch)) {
      case Arrival::crosses: return true;
      case Arrival::passes: return false;
      default: return solve_in(stretch);
    }
  }

  bool solve(std::uint32_t index, const Cell& cell, double t0, double t1, bool starts_here) {
    fields_.set_up(blob_.components, blob_.grid.items.data() + cell.first, cell.count(), origin_, direction_, t0, t1);
    if (fields_.upper_bound() < 0 && !starts_here) {
      is_node_valid_ = false;
      if (side_ == Side::inside) return cross(t0, index);
      side_ = Side::outside;
      return false;
    }
    Solver solver(fields_, side_ == Side::inside ? -1.0 : 1.0, lengths_, counters_);
    Node a = is_node_valid_ ? node_ : solver.node(t0);
    if (side_ == Side::unknown) {
      side_ = (starts_here ? leaves_inwards(fields_, a) : a.value > a.noise) ? Side::inside : Side::outside;
      if (side_ == Side::inside) {
        a.value = -a.value;
        a.slope = -a.slope;
        solver.turn_inside();
      }
    }
    if (starts_here) a.value = 0;
    const Node b = solver.node(t1);
    if (const std::optional<double> t = solver.first_root(a, b, starts_here, ray_->any)) return cross(*t, index);
    node_ = b;
    is_node_valid_ = true;
    return false;
  }

  const CompiledBlob& blob_;
  const SolverSettings& settings_;
  typename Solver::Fields fields_;
  TraceCounters& counters_;

  const BlobRay* ray_ = nullptr;
  Vec3 origin_, direction_;
  double base_ = 0;
  typename Solver::Lengths lengths_{};
  bool starts_on_surface_ = false;
  Side side_ = Side::unknown;
  double reached_ = 0;  ///< how far the ray has been followed
  std::uint32_t last_cell_ = scene::kNone;  ///< the last one solved: its list holds what matters at `reached_`
  bool is_node_valid_ = false;
  Node node_{};  ///< at reached_, on the ray's side
  BlobHit hit_;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
