// The published solver (Sherstyuk 1999, §3), for comparison: `paper:K`. Every field that the ray meets is replaced,
// over the whole stretch of the ray in its support, by K cubic Hermite interpolants on equal intervals; their sum is a
// cubic between any two neighbouring ends, and its first root is taken for the surface. Nothing bounds the
// interpolants' error (with K = 2 a hard Gaussian's front is moved outward by a good part of its radius), and nothing
// is polished: that is what it is here to show. Faithful also in that a field counts wherever its support reaches, so
// the grid it walks must keep all lists.
#if defined(ISL_RENDERER_SOLVERS_PAPER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_PAPER_INL_H_
#undef ISL_RENDERER_SOLVERS_PAPER_INL_H_
#else
#define ISL_RENDERER_SOLVERS_PAPER_INL_H_
#endif

#include "renderer/compiled_scene.h"
#include "renderer/fields/kernels/kernels-inl.h"
#include "renderer/grid/grid_walk-inl.h"
#include "renderer/solvers/blob_ray.h"
#include "renderer/solvers/paper_memory.h"
#include "renderer/solvers/paper_sums.h"
#include "renderer/solvers/paper_support.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class PaperSearch {
 public:
  PaperSearch(const CompiledBlob& blob, const SolverSettings& settings, PaperMemory& memory, TraceCounters& counters)
      : blob_(blob), settings_(settings), m_(memory), counters_(counters) {}

  [[nodiscard]] BlobHit first_hit(const BlobRay& ray) {
    const Grid& grid = blob_.grid;
    BoxSpan span{1, 0};
    if (grid.cell_size > 0) span = clip_to_box(grid.box, ray.origin, ray.direction, 0, ray.t_max);
    const bool meets_grid = span.enter < span.leave;
    if (!meets_grid && grid.beyond == scene::kNone) return {};
    // With half-spaces or sheets the whole ray counts, without them what lies in the grid.
    const double base = grid.beyond == scene::kNone ? span.enter : 0;
    const Vec3 origin = ray.origin + ray.direction * base;
    double reach = meets_grid ? span.leave - base : 0;
    m_.begin_ray(blob_.components.size());
    for (const std::uint32_t item : grid.endless_items) reach = std::max(reach, end_of_change(item, origin, ray.direction));
    reach = std::min(reach, ray.t_max - base);
    for (const std::uint32_t item : grid.endless_items) add_endless(item, origin, ray.direction, reach);
    if (meets_grid) {
      walk(grid, ray.origin + ray.direction * span.enter, ray.direction, 0, span.leave - span.enter,
           [&](std::uint32_t index, const Cell& cell, double, double t1) HWY_ATTR {
             ++counters_.cells;
             m_.cells.push_back({span.enter - base + t1, index});
             for (std::uint32_t i = 0; i < grid.list_count(cell); ++i) {
               const ItemList list = grid.list(cell, i);
               for (std::uint32_t k = 0; k < list.count; ++k) {
                 const std::uint32_t item = grid.items[list.first + k];
                 if (m_.meet(item)) add_field(item, origin, ray.direction);
               }
             }
             return false;
           });
    }
    return sweep(ray, base, reach, meets_grid ? span.enter - base : reach);
  }

 private:
  [[nodiscard]] static KernelValue kernel_value(const KernelConstants& k, const Octet& v) {
    KernelValue result;
    with_kernel(k, [&](const auto& kernel) HWY_ATTR { result = kernel.value_and_slope(v); });
    return result;
  }

  /// The interpolants of one component: its support on the ray is one interval, the sets v ≤ c being convex.
  void add_field(std::uint32_t item, const Vec3& origin, const Vec3& direction) {
    const FieldLine line(blob_.components, item, origin, direction);
    double begin, end;
    if (support_on(line, begin, end)) interpolate(line, begin, end, 0, 0);
  }

  /// K interpolants of a field on a stretch at whose ends it is flat and has these values.
  void interpolate(const FieldLine& line, double begin, double end, double at_begin, double at_end) {
    const FieldGroup& group = line.group;
    const double amplitude = line.table.amplitude[line.item];
    const int k = settings_.interpolants;
    const double h = (end - begin) / k;
    PaperMemory::Interpolant previous{begin, at_begin, 0, 0, 0, 0, branch_of(line.item)};
    for (int first = 1; first <= k; first += static_cast<int>(kOctet)) {
      alignas(64) double v[kOctet], dv[kOctet], value[kOctet], slope[kOctet];
      for (int j = 0; j < static_cast<int>(kOctet); ++j) {
        const KernelArgument a = line.at(begin + h * std::min(first + j, k));
        v[j] = std::min(a.v, group.kernel.support);
        dv[j] = a.slope;
      }
      if (group.kernel.is_convolved) {
        for (int j = 0; j < static_cast<int>(kOctet); ++j) {
          const CurveSample f = line.sample(begin + h * std::min(first + j, k));
          value[j] = amplitude * f.value;
          slope[j] = amplitude * f.gradient.dot(line.direction);
        }
      } else {
        const KernelValue phi = kernel_value(group.kernel, load(v));
        store(Octet(amplitude) * phi.value, value);
        store(Octet(amplitude) * phi.slope * load(dv), slope);
      }
      for (int j = 0; j < static_cast<int>(kOctet) && first + j <= k; ++j) {
        const bool is_last = first + j == k;
        PaperMemory::Interpolant piece = previous;
        piece.t1 = is_last ? end : begin + h * (first + j);
        piece.value1 = is_last ? at_end : value[j];
        piece.slope1 = is_last ? 0 : slope[j];
        m_.interpolants.push_back(piece);
        previous = {piece.t1, piece.value1, piece.slope1, 0, 0, 0, piece.branch};
        if (!is_last) ++counters_.field_evaluations;
      }
    }
  }

  /// Along a ray, the plane where a half-space or the far side of a sheet begins, and the one where its field ends. dx is 0 where
  /// they are farther than any scene reaches.
  struct EndlessLine {
    double dx, begins, ends;
  };
  [[nodiscard]] EndlessLine endless_line(std::uint32_t item, const Vec3& origin, const Vec3& direction) const {
    const FieldGroup& group = blob_.components.group_of(item);
    return blob_.components.with_endless(group, item, [&](const auto& shape) -> EndlessLine {
      const double x = (origin - shape.at).dot(shape.normal), dx = direction.dot(shape.normal);
      const double reach = shape.radius * ComponentTable::support_root(group);
      const double begins = (shape.kBorders.front() * reach - x) / dx, ends = (shape.kBorders.back() * reach - x) / dx;
      return {std::max(std::abs(begins), std::abs(ends)) < 1e150 ? dx : 0, begins, ends};
    });
  }
  /// Behind it the field is constant along the ray.
  [[nodiscard]] double end_of_change(std::uint32_t item, const Vec3& origin, const Vec3& direction) const {
    const EndlessLine line = endless_line(item, origin, direction);
    return line.dx == 0 ? 0 : std::max(line.begins, line.ends);
  }
  void add_endless(std::uint32_t item, const Vec3& origin, const Vec3& direction, double reach) {
    if (!m_.meet(item)) return;
    const ComponentTable& table = blob_.components;
    const FieldGroup& group = table.group_of(item);
    const EndlessLine h = endless_line(item, origin, direction);
    const FieldLine line(table, item, origin, direction);
    const auto add_constant = [&](double from, double to, double v) {
      const double value = table.amplitude[item] * kernel_profile(group.kernel, v);
      if (from < to) m_.interpolants.push_back({from, value, 0, to, value, 0, branch_of(item)});
    };
    if (h.dx == 0) return add_constant(0, reach, line.at(0).v);
    if (group.skeleton == scene::Skeleton::sheet)
      return interpolate(line, std::min(h.begins, h.ends), std::max(h.begins, h.ends), 0, 0);
    const double peak = table.amplitude[item] * kernel_profile(group.kernel, 0);
    if (h.dx > 0) {
      add_constant(0, h.begins, 0);
      interpolate(line, h.begins, h.ends, peak, 0);
    } else {
      interpolate(line, h.ends, h.begins, 0, peak);
      add_constant(h.begins, reach, 0);
    }
  }

  [[nodiscard]] std::uint32_t branch_of(std::uint32_t item) const {
    return blob_.components.branch.empty() ? 0 : blob_.components.branch[item];
  }

  /// The sum of the interpolants between neighbouring ends, in order along the ray. The grid begins at t = `grid_begin`.
  [[nodiscard]] BlobHit sweep(const BlobRay& ray, double base, double reach, double grid_begin) {
    std::sort(m_.interpolants.begin(), m_.interpolants.end(),
              [](const auto& p, const auto& q) { return p.t0 != q.t0 ? p.t0 < q.t0 : p.t1 < q.t1; });
    m_.ends.clear();
    for (const PaperMemory::Interpolant& piece : m_.interpolants) {
      m_.ends.push_back(piece.t0);
      m_.ends.push_back(piece.t1);
    }
    m_.ends.push_back(0);
    std::sort(m_.ends.begin(), m_.ends.end());
    m_.active.clear();
    PaperSums sums(blob_, m_);
    std::size_t next = 0;
    double side = 0;
    for (std::size_t i = 0; i + 1 < m_.ends.size(); ++i) {
      const double from = m_.ends[i], to = m_.ends[i + 1];
      while (next < m_.interpolants.size() && m_.interpolants[next].t0 <= from)
        m_.active.push_back(m_.interpolants[next++]);
      std::erase_if(m_.active, [&](const auto& piece) { return piece.t1 <= from; });
      if (to <= 0 || from >= reach || !(to > from)) continue;
      sums.add_up(from, to);
      double greatest = m_.sums[0].value0;
      for (const HermiteSum& sum : m_.sums) greatest = std::max(greatest, sum.value0);
      // A ray that leaves the surface is outside, whatever the interpolants say of its start.
      if (side == 0) side = greatest > 0 && !ray.starts_on_surface && base == 0 ? -1 : 1;
      if (side * greatest >= 0 && ray.starts_on_surface) continue;
      const double u = side > 0 ? sums.enters_at(to - from) : sums.leaves_at(to - from);
      const double t = from + u * (to - from);
      if (u > 1 || t > reach || t <= 0) continue;
      const auto cell = std::find_if(m_.cells.begin(), m_.cells.end(), [&](const auto& c) { return t <= c.t1; });
      const bool is_beyond = t < grid_begin || cell == m_.cells.end();
      const std::uint32_t index = is_beyond ? blob_.grid.beyond : cell->index;
      if (index == scene::kNone) return {};
      return {base + t, index, side < 0};
    }
    BlobHit miss;
    miss.from_inside = side < 0;
    return miss;
  }

  const CompiledBlob& blob_;
  const SolverSettings& settings_;
  PaperMemory& m_;
  TraceCounters& counters_;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
