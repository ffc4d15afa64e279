// The published solver (Sherstyuk 1999, §3 and §4), for comparison: `paper:K`. Every field that the ray meets is
// replaced, over the whole stretch of the ray in its support, by K cubic Hermite interpolants on equal intervals; their
// sum is a cubic between any two neighbouring ends, and its first root is taken for the surface. Nothing bounds the
// interpolants' error (with K = 2 a hard Gaussian's front is moved outward by a good part of its radius), and nothing
// is polished: the solver is here to show this error. As in the paper, a field counts wherever its support reaches, so
// the grid must keep all lists. The optimisations are switches (paper_switches.h), and `iso` is the same solver with
// other nodes (paper_fields-inl.h).
//
// Clusters of overlapping fields are permanent (the lists of the grid's cells, with the sweep following the walk from
// cell to cell) or volatile (gathered from the whole ray and put in order before the sweep begins).
#if defined(ISL_RENDERER_SOLVERS_PUBLISHED_PAPER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_PUBLISHED_PAPER_INL_H_
#undef ISL_RENDERER_SOLVERS_PUBLISHED_PAPER_INL_H_
#else
#define ISL_RENDERER_SOLVERS_PUBLISHED_PAPER_INL_H_
#endif

#include "renderer/compiled/compiled_scene.h"
#include "renderer/grid/grid_walk-inl.h"
#include "renderer/rays/blob_ray.h"
#include "renderer/rays/trace_counters.h"
#include "renderer/solvers/published/paper_fields-inl.h"
#include "renderer/solvers/published/paper_memory.h"
#include "renderer/solvers/published/paper_sweep-inl.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class PaperSearch {
 public:
  PaperSearch(const CompiledBlob& blob, const SolverSettings& settings, PaperMemory& memory, TraceCounters& counters)
      : blob_(blob),
        switches_(settings.paper),
        m_(memory),
        counters_(counters),
        fields_(blob, settings, memory, counters) {}

  [[nodiscard]] BlobHit first_hit(const BlobRay& ray) {
    const Grid& grid = blob_.grid;
    BoxSpan span{1, 0};
    if (grid.cell_size > 0) span = clip_to_box(grid.box, ray.origin, ray.direction, 0, ray.t_max);
    const bool meets_grid = span.enter < span.leave;
    if (!meets_grid && grid.beyond == scene::kNone) return {};
    // With half-spaces or sheets the whole ray counts; without them, only its part in the grid does.
    const double base = grid.beyond == scene::kNone ? span.enter : 0;
    fields_.set_ray(ray.origin + ray.direction * base, ray.direction);
    m_.begin_ray(blob_.components.size(), switches_.pools);
    double reach = meets_grid ? span.leave - base : 0;
    for (const std::uint32_t item : grid.endless_items) reach = std::max(reach, fields_.end_of_change(item));
    reach = std::min(reach, ray.t_max - base);
    for (const std::uint32_t item : grid.endless_items) fields_.meet_endless(item, reach);
    PaperSweep sweep(blob_, switches_, {base, reach, ray.starts_on_surface, ray.may_go_in}, fields_, m_);
    const double grid_begin = meets_grid ? span.enter - base : reach;
    std::optional<double> crossing;
    if (meets_grid) {
      walk(grid, ray.origin + ray.direction * span.enter, ray.direction, 0, span.leave - span.enter,
           [&](std::uint32_t index, const Cell& cell, double, double t1) HWY_ATTR {
             ++counters_.cells;
             const double leave = grid_begin + t1;
             m_.cells.push_back({leave, index});
             meet_fields(cell);
             if (switches_.permanent) crossing = sweep.advance(leave);
             return crossing.has_value();
           });
    }
    if (!crossing) crossing = sweep.advance(std::numeric_limits<double>::infinity());
    BlobHit hit;
    hit.from_inside = sweep.is_inside();
    if (!crossing) return hit;
    const double t = *crossing;
    const auto cell = std::find_if(m_.cells.begin(), m_.cells.end(), [&](const auto& c) { return t <= c.t1; });
    const bool is_beyond = t < grid_begin || cell == m_.cells.end();
    hit.cell = is_beyond ? grid.beyond : cell->index;
    if (hit.cell == scene::kNone) return {};
    hit.t = base + t;
    if (switches_.reuse && m_.keeps_records) hit.cell = record(sweep, t);
    return hit;
  }

 private:
  void meet_fields(const Cell& cell) {
    const Grid& grid = blob_.grid;
    for (std::uint32_t i = 0; i < grid.list_count(cell); ++i) {
      const ItemList list = grid.list(cell, i);
      for (std::uint32_t k = 0; k < list.count; ++k) fields_.meet(grid.items[list.first + k]);
    }
  }

  /// Stores what the sweep knows of the surface at t, and returns the number under which shading finds it.
  [[nodiscard]] std::uint32_t record(const PaperSweep& sweep, double t) {
    std::vector<std::uint32_t>& crossing = m_.waiting;  // free for reuse, because the ray ends here
    crossing.clear();
    for (std::size_t i = 0; i < m_.active.size(); ++i) {
      if (sweep.crosses(i)) crossing.push_back(m_.active[i]);
    }
    std::sort(crossing.begin(), crossing.end(),
              [&](std::uint32_t a, std::uint32_t b) { return m_.fields[a].item < m_.fields[b].item; });
    const auto first = static_cast<std::uint32_t>(m_.record_items.size());
    for (const std::uint32_t index : crossing) {
      m_.record_items.push_back(m_.fields[index].item);
      m_.record_values.push_back(m_.point_at(m_.fields[index], t).value);
    }
    m_.records.push_back({&blob_, first, static_cast<std::uint32_t>(m_.record_items.size()) - first});
    return static_cast<std::uint32_t>(m_.records.size() - 1);
  }

  const CompiledBlob& blob_;
  PaperSwitches switches_;
  PaperMemory& m_;
  TraceCounters& counters_;
  PaperFields fields_;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
