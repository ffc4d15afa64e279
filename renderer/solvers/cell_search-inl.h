// The certified search for a blob's surface along a ray: the grid's cells in order, each solved by itself (hermite-inl.h).
// The ray carries which side of the surface it is on; a crossing is a change of that side, whether a cell's solver found it or
// two neighbours disagree by a rounding about a root on their common border.
#if defined(ISL_RENDERER_SOLVERS_CELL_SEARCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_CELL_SEARCH_INL_H_
#undef ISL_RENDERER_SOLVERS_CELL_SEARCH_INL_H_
#else
#define ISL_RENDERER_SOLVERS_CELL_SEARCH_INL_H_
#endif

#include "renderer/compiled_scene.h"
#include "renderer/grid/grid_walk-inl.h"
#include "renderer/solvers/blob_ray.h"
#include "renderer/solvers/hermite-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class CellSearch {
 public:
  CellSearch(const CompiledBlob& blob, const SolverSettings& settings, LaneMemory& memory, TraceCounters& counters)
      : blob_(blob), settings_(settings), fields_(memory), counters_(counters) {}

  [[nodiscard]] BlobHit first_hit(const BlobRay& ray) {
    const Grid& grid = blob_.grid;
    if (grid.is_empty()) return {};
    const BoxSpan span = clip_to_box(grid.box, ray.origin, ray.direction, 0, ray.t_max);
    if (!(span.enter < span.leave)) return {};

    // From far away the ray is taken up again where it meets the grid, so that the fields see small numbers.
    base_ = span.enter;
    origin_ = ray.origin + ray.direction * base_;
    direction_ = ray.direction;
    starts_on_surface_ = ray.starts_on_surface && base_ == 0;
    any_ = ray.any;
    side_ = base_ > 0 ? kOutside : kUnknown;
    reached_ = 0;
    last_cell_ = scene::kNone;
    is_node_valid_ = false;
    hit_ = {};
    const Vec3 diagonal = grid.box.size();
    const double stretch = diagonal.length() / ray.direction.length();
    const double tolerance = settings_.at(ray.path_length + base_);
    // Certification may stop at a thousandth of the tolerance, and must at 2⁻⁴⁰ of the blob: a pair of roots closer than that
    // encloses a depth below the rounding of F.
    shortest_ = std::max(0x1p-40 * stretch, 1e-3 * tolerance);
    walk(grid, origin_, direction_, 0, span.leave - base_,
         [&](std::uint32_t index, const Cell& cell, double t0, double t1) HWY_ATTR { return visit(index, cell, t0, t1); });
    return hit_;
  }

 private:
  static constexpr double kOutside = 1, kInside = -1, kUnknown = 0;

  /// The ray changes sides at t, on the border of `cell` or in it.
  bool cross(double t, std::uint32_t cell) {
    hit_ = {base_ + t, cell, side_ == kInside};
    return true;
  }

  /// The cell whose list to shade with where a crossing falls between cells.
  [[nodiscard]] std::uint32_t last_solved_or(std::uint32_t index) const { return last_cell_ == scene::kNone ? index : last_cell_; }

  bool visit(std::uint32_t index, const Cell& cell, double t0, double t1) {
    ++counters_.cells;
    if (t0 > reached_ || !is_node_valid_) {
      // Between leaf cells lie only cells certainly outside.
      if (t0 > reached_) {
        if (side_ == kInside) return cross(reached_, last_solved_or(index));
        side_ = kOutside;
      }
      is_node_valid_ = false;
    }
    if (cell.kind() == CellKind::inside) {
      if (side_ == kOutside) return cross(t0, last_solved_or(index));
      side_ = kInside;
      is_node_valid_ = false;
      reached_ = t1;
      return false;
    }
    return solve(index, cell, t0, t1);
  }

  bool solve(std::uint32_t index, const Cell& cell, double t0, double t1) {
    const bool starts_here = starts_on_surface_ && t0 == 0;
    last_cell_ = index;
    reached_ = t1;
    fields_.set_up(blob_.components, blob_.grid.items.data() + cell.first, cell.count(), origin_, direction_, t0, t1);
    if (fields_.upper_bound() < 0 && !starts_here) {
      is_node_valid_ = false;
      if (side_ == kInside) return cross(t0, index);
      side_ = kOutside;
      return false;
    }
    HermiteSolver solver(fields_, side_ == kInside ? -1.0 : 1.0, shortest_, counters_);
    Node a = is_node_valid_ ? node_ : solver.node(t0);
    if (side_ == kUnknown) {
      side_ = (starts_here ? leaves_inwards(a) : a.value > a.noise) ? kInside : kOutside;
      if (side_ == kInside) {
        a.value = -a.value;
        a.slope = -a.slope;
        solver.turn_inside();
      }
    }
    if (starts_here) a.value = 0;
    const Node b = solver.node(t1);
    if (const std::optional<double> t = solver.first_root(a, b, starts_here, any_)) return cross(*t, index);
    node_ = b;
    is_node_valid_ = true;
    return false;
  }

  /// Whether a ray that starts on the surface goes in: by the slope there or, where that is lost in rounding (a tangent ray), by
  /// the curvature.
  [[nodiscard]] bool leaves_inwards(const Node& start) const {
    if (std::abs(start.slope) > start.slope_noise) return start.slope > 0;
    return fields_.curvature(start.t) > 0;
  }

  const CompiledBlob& blob_;
  const SolverSettings& settings_;
  RayLanes fields_;
  TraceCounters& counters_;

  Vec3 origin_, direction_;
  double base_ = 0, shortest_ = 0;
  bool starts_on_surface_ = false, any_ = false;
  double side_ = kUnknown;
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
