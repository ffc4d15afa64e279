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
#include "renderer/solvers/cubic.h"
#include "renderer/solvers/paper_memory.h"

#include <algorithm>
#include <array>
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
    if (grid.is_empty()) return {};
    const BoxSpan span = clip_to_box(grid.box, ray.origin, ray.direction, 0, ray.t_max);
    if (!(span.enter < span.leave)) return {};
    const Vec3 origin = ray.origin + ray.direction * span.enter;
    const double reach = span.leave - span.enter;
    m_.begin_ray(blob_.components.size());
    walk(grid, origin, ray.direction, 0, reach, [&](std::uint32_t index, const Cell& cell, double, double t1) HWY_ATTR {
      ++counters_.cells;
      m_.cells.push_back({t1, index});
      for (std::uint32_t i = 0; i < cell.count(); ++i) {
        const std::uint32_t item = grid.items[cell.first + i];
        if (m_.meet(item)) add_field(item, origin, ray.direction);
      }
      return false;
    });
    return sweep(ray, span.enter, reach);
  }

 private:
  /// v and dv/dt of one component along the ray.
  struct Argument {
    double v, slope;
  };
  struct Line {
    const ComponentTable& table;
    const FieldGroup& group;
    std::uint32_t item;
    Vec3 origin, direction;

    [[nodiscard]] Argument at(double t) const {
      const Vec3 p = origin + direction * t;
      const Foot foot = table.with_skeleton(group, item, [&](const auto& skeleton) { return skeleton.nearest(p); });
      const Vec3 half_gradient = foot.offset * (ComponentTable::v_scale(group) * foot.inverse_radius2);
      return {half_gradient.dot(foot.offset), 2 * half_gradient.dot(direction)};
    }
  };

  [[nodiscard]] static KernelValue kernel_value(const KernelConstants& k, const Octet& v) {
    KernelValue result;
    with_kernel(k, [&](const auto& kernel) HWY_ATTR { result = kernel.value_and_slope(v); });
    return result;
  }

  /// The interpolants of one component: its support on the ray is one interval, the sets v ≤ c being convex.
  void add_field(std::uint32_t item, const Vec3& origin, const Vec3& direction) {
    const ComponentTable& table = blob_.components;
    const FieldGroup& group = table.group_of(item);
    Line line{table, group, item, origin, direction};
    if (group.is_mapped) {
      const scene::Transform& map = table.blob_from_component(group, item);
      line.origin = map.inverse_point(origin);
      line.direction = map.inverse_vector(direction);
    }
    double begin, end;
    if (!support_on(line, begin, end)) return;
    const int k = settings_.interpolants;
    const double h = (end - begin) / k;
    PaperMemory::Interpolant previous{begin, 0, 0, 0, 0, 0};
    for (int first = 1; first <= k; first += static_cast<int>(kOctet)) {
      alignas(64) double v[kOctet], dv[kOctet], value[kOctet], slope[kOctet];
      for (int j = 0; j < static_cast<int>(kOctet); ++j) {
        const Argument a = line.at(begin + h * std::min(first + j, k));
        v[j] = std::min(a.v, group.kernel.support);
        dv[j] = a.slope;
      }
      const KernelValue phi = kernel_value(group.kernel, load(v));
      store(Octet(table.amplitude[item]) * phi.value, value);
      store(Octet(table.amplitude[item]) * phi.slope * load(dv), slope);
      for (int j = 0; j < static_cast<int>(kOctet) && first + j <= k; ++j) {
        const bool is_last = first + j == k;
        PaperMemory::Interpolant piece = previous;
        piece.t1 = is_last ? end : begin + h * (first + j);
        piece.value1 = is_last ? 0 : value[j];
        piece.slope1 = is_last ? 0 : slope[j];
        m_.interpolants.push_back(piece);
        previous = {piece.t1, piece.value1, piece.slope1, 0, 0, 0};
        if (!is_last) ++counters_.field_evaluations;
      }
    }
  }

  /// Where v < support: from its first to its last point on the line.
  [[nodiscard]] static bool support_on(const Line& line, double& begin, double& end) {
    const double support = line.group.kernel.support, dd = line.direction.length2();
    if (line.group.form == FieldForm::point) {
      const ComponentTable& table = line.table;
      const Vec3 centre(table.x[line.item], table.y[line.item], table.z[line.item]);
      const double scale = table.scale[line.item];
      const QuadraticPiece v = sphere_piece(centre, scale, line.origin, line.direction, 0, 0);
      if (!(v.q0 < support)) return false;
      const double half = std::sqrt((support - v.q0) / v.kappa);
      begin = v.middle - half;
      end = v.middle + half;
      return half > 0;
    }
    // The line beyond these two is out of reach.
    const double root_q = ComponentTable::support_root(line.group), start = line.origin.dot(line.direction);
    const auto farthest = [&](const Vec3& n) {
      const std::array<Reach, 2> reach =
          line.table.with_skeleton(line.group, line.item, [&](const auto& skeleton) { return skeleton.reach(n); });
      const double spread = root_q * std::sqrt(dd);
      return std::max(reach[0].coordinate + reach[0].radius * spread, reach[1].coordinate + reach[1].radius * spread);
    };
    const double low = (-farthest(-line.direction) - start) / dd, high = (farthest(line.direction) - start) / dd;
    double first = 0, last = 0;  // points in the support
    if (line.group.form == FieldForm::circle) {
      // A line can leave a torus and come back; a stretch thinner than these steps goes unseen, as the mode allows.
      constexpr int kSteps = 256;
      bool is_met = false;
      for (int i = 1; i < kSteps; ++i) {
        const double t = low + (high - low) * i / kSteps;
        if (!(line.at(t).v < support)) continue;
        if (!is_met) first = t;
        last = t;
        is_met = true;
      }
      if (!is_met) return false;
    } else {
      double before = low, behind = high;
      for (int i = 0; i < 60; ++i) {  // v is quasi-convex along the ray: its slope changes sign once
        const double middle = 0.5 * (before + behind);
        (line.at(middle).slope > 0 ? behind : before) = middle;
      }
      first = last = 0.5 * (before + behind);
      if (!(line.at(first).v < support)) return false;
    }
    const auto border = [&](double inner, double outer) {
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (inner + outer);
        (line.at(middle).v < support ? inner : outer) = middle;
      }
      return inner;
    };
    begin = border(first, low);
    end = border(last, high);
    return end > begin;
  }

  /// The sum of the interpolants between neighbouring ends, in order along the ray.
  [[nodiscard]] BlobHit sweep(const BlobRay& ray, double base, double reach) {
    std::sort(m_.interpolants.begin(), m_.interpolants.end(),
              [](const auto& p, const auto& q) { return p.t0 != q.t0 ? p.t0 < q.t0 : p.t1 < q.t1; });
    m_.ends.clear();
    for (const PaperMemory::Interpolant& piece : m_.interpolants) {
      m_.ends.push_back(piece.t0);
      m_.ends.push_back(piece.t1);
    }
    m_.ends.push_back(0);
    std::sort(m_.ends.begin(), m_.ends.end());
    const double threshold = blob_.components.threshold;
    m_.active.clear();
    std::size_t next = 0;
    double side = 0;
    for (std::size_t i = 0; i + 1 < m_.ends.size(); ++i) {
      const double from = m_.ends[i], to = m_.ends[i + 1];
      while (next < m_.interpolants.size() && m_.interpolants[next].t0 <= from)
        m_.active.push_back(m_.interpolants[next++]);
      std::erase_if(m_.active, [&](const auto& piece) { return piece.t1 <= from; });
      if (to <= 0 || from >= reach || !(to > from)) continue;
      double f0 = -threshold, f1 = -threshold, d0 = 0, d1 = 0;
      for (const PaperMemory::Interpolant& piece : m_.active) {
        const CubicPoint a = piece.at(from), b = piece.at(to);
        f0 += a.value;
        d0 += a.slope;
        f1 += b.value;
        d1 += b.slope;
      }
      // A ray that leaves the surface is outside, whatever the interpolants say of its start.
      if (side == 0) side = f0 > 0 && !ray.starts_on_surface && base == 0 ? -1 : 1;
      if (side * f0 >= 0 && ray.starts_on_surface) continue;
      const double h = to - from;
      const double u =
          first_crossing_of_cubic(side * f0, side * (f0 + h * d0 / 3), side * (f1 - h * d1 / 3), side * f1);
      const double t = from + u * h;
      if (u > 1 || t > reach) continue;
      if (t <= 0) continue;
      const auto cell = std::find_if(m_.cells.begin(), m_.cells.end(), [&](const auto& c) { return t <= c.t1; });
      if (cell == m_.cells.end()) return {};
      return {base + t, cell->index, side < 0};
    }
    return {};
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
