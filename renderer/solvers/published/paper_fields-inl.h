// The fields that a ray meets, for the published solver: where each begins and ends, the nodes of its interpolants, and
// the values there once the sweep asks for them.
//
// `paper:K` has K interpolants on equal intervals. `iso` (an idea of ours, as unbounded as the paper's) puts nodes
// where the field alone is at its own surface. Value and slope there are constants of the kernel, so that these two
// nodes cost nothing; a third node is in the middle between them. If the ray passes outside that surface, `iso` is
// `paper:2`.
#if defined(ISL_RENDERER_SOLVERS_PUBLISHED_PAPER_FIELDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_PUBLISHED_PAPER_FIELDS_INL_H_
#undef ISL_RENDERER_SOLVERS_PUBLISHED_PAPER_FIELDS_INL_H_
#else
#define ISL_RENDERER_SOLVERS_PUBLISHED_PAPER_FIELDS_INL_H_
#endif

#include "renderer/compiled/compiled_scene.h"
#include "renderer/fields/kernels/kernels-inl.h"
#include "renderer/rays/blob_ray.h"
#include "renderer/rays/trace_counters.h"
#include "renderer/solvers/published/paper_memory.h"
#include "renderer/solvers/published/paper_support.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class PaperFields {
 public:
  PaperFields(const CompiledBlob& blob, const SolverSettings& settings, PaperMemory& memory, TraceCounters& counters)
      : blob_(blob), table_(blob.components), settings_(settings), m_(memory), counters_(counters) {}

  void set_ray(const Vec3& origin, const Vec3& direction) {
    origin_ = origin;
    direction_ = direction;
  }

  /// Adds a component to the waiting fields if the ray crosses its support.
  void meet(std::uint32_t item) {
    if (!m_.meet(item)) return;
    const FieldLine line(table_, item, origin_, direction_);
    const auto [support, least] = nearness(line, line.group.kernel.support);
    if (support.is_empty()) return;
    begin_field(support.begin, 0);
    if (settings_.name != SolverName::iso || !add_iso_nodes(line, least, support))
      add_even_nodes(support.begin, support.end);
    end_field(item, support.end, 0, settings_.paper.reject ? peak(line, least) : 0);
  }

  /// The t behind which the field of a half-space or sheet is constant along the ray.
  [[nodiscard]] double end_of_change(std::uint32_t item) const {
    const EndlessLine line = endless_line(item);
    return line.dx == 0 ? 0 : std::max(line.begins, line.ends);
  }
  /// Adds a half-space or a sheet, as far as `reach`: a slope and, before or behind that of a half-space, a constant.
  void meet_endless(std::uint32_t item, double reach) {
    if (!m_.meet(item)) return;
    const FieldGroup& group = table_.group_of(item);
    const EndlessLine h = endless_line(item);
    if (h.dx == 0) {
      const double v = FieldLine(table_, item, origin_, direction_).at(0).v;
      return add_constant(item, 0, reach, table_.amplitude[item] * kernel_profile(group.kernel, v));
    }
    const double most = table_.amplitude[item] * kernel_profile(group.kernel, 0);
    const double begin = std::min(h.begins, h.ends), end = std::max(h.begins, h.ends);
    if (!h.fills_behind) {
      add_slope(item, begin, end, 0, 0, most);
    } else if (h.dx > 0) {
      add_constant(item, 0, begin, most);
      add_slope(item, begin, end, most, 0, most);
    } else {
      add_slope(item, begin, end, 0, most, most);
      add_constant(item, end, reach, most);
    }
  }

  /// Evaluates the values that a field's interpolants wait for.
  void interpolate(PaperMemory::Field& field) {
    if (field.first_unknown == field.end_unknown) return;
    const FieldLine line(table_, field.item, origin_, direction_);
    const double amplitude = table_.amplitude[field.item];
    counters_.field_evaluations += field.end_unknown - field.first_unknown;
    for (; field.first_unknown < field.end_unknown; field.first_unknown += static_cast<std::uint32_t>(kOctet)) {
      PaperMemory::Node* const nodes = m_.nodes.data() + field.first_unknown;
      const std::uint32_t count = std::min(static_cast<std::uint32_t>(kOctet), field.end_unknown - field.first_unknown);
      if (line.group.kernel.is_convolved) {
        for (std::uint32_t i = 0; i < count; ++i) {
          const CurveSample f = line.sample(nodes[i].t);
          nodes[i].value = amplitude * f.value;
          nodes[i].slope = amplitude * f.gradient.dot(line.direction);
        }
        continue;
      }
      alignas(64) double v[kOctet], dv[kOctet], value[kOctet], slope[kOctet];
      for (std::uint32_t i = 0; i < kOctet; ++i) {
        if (i < count) {
          const ArgumentOnLine at = line.at(nodes[i].t);
          v[i] = std::min(at.v, line.group.kernel.support);
          dv[i] = at.slope;
        } else {
          v[i] = v[0];
          dv[i] = dv[0];
        }
      }
      const KernelValue phi = kernel_value(line.group.kernel, load(v));
      store(Octet(amplitude) * phi.value, value);
      store(Octet(amplitude) * phi.slope * load(dv), slope);
      for (std::uint32_t i = 0; i < count; ++i) {
        nodes[i].value = value[i];
        nodes[i].slope = slope[i];
      }
    }
    field.first_unknown = field.end_unknown;
  }

 private:
  /// Along a ray, the plane where a half-space or the far side of a sheet begins, and the one where its field ends. dx
  /// is 0 where they are farther than any scene reaches.
  struct EndlessLine {
    double dx, begins, ends;
    bool fills_behind;
  };

  [[nodiscard]] static KernelValue kernel_value(const KernelConstants& k, const Octet& v) {
    KernelValue result;
    with_kernel(k, [&](const auto& kernel) HWY_ATTR { result = kernel.value_and_slope(v); });
    return result;
  }

  [[nodiscard]] EndlessLine endless_line(std::uint32_t item) const {
    const FieldGroup& group = table_.group_of(item);
    return table_.with_endless(group, item, [&](const auto& shape) -> EndlessLine {
      const double x = (origin_ - shape.at).dot(shape.normal), dx = direction_.dot(shape.normal);
      const double reach = shape.radius * ComponentTable::support_root(group);
      const double begins = (shape.kBorders.front() * reach - x) / dx, ends = (shape.kBorders.back() * reach - x) / dx;
      return {std::max(std::abs(begins), std::abs(ends)) < 1e150 ? dx : 0, begins, ends, shape.kFillsBehind};
    });
  }

  /// An upper bound of a field's value if v is at least `least`.
  [[nodiscard]] double peak(const FieldLine& line, double least) const {
    const double amplitude = table_.amplitude[line.item];
    if (!(amplitude > 0)) return 0;
    if (!line.group.kernel.is_convolved) return amplitude * blob_.paper.profile_bound(table_, line.group, least);
    const double q = least / ComponentTable::v_scale(line.group);
    return amplitude * table_.with_skeleton(line.group, line.item, [&](const auto& skeleton) {
      return curve_most(line.group.kernel, skeleton, q);
    });
  }

  /// Adds the nodes of `iso`. False if there are none: the field alone has no surface that the ray passes through.
  bool add_iso_nodes(const FieldLine& line, double least, const RayInterval& support) {
    const IsoLevel& level = blob_.paper.iso[line.item];
    if (!(least < level.v)) return false;
    const RayInterval iso = nearness(line, level.v).below;
    if (!(support.begin < iso.begin && iso.begin < iso.end && iso.end < support.end)) return false;
    m_.nodes.push_back({iso.begin, table_.threshold, level.slope * line.at(iso.begin).slope});
    m_.nodes.push_back({iso.begin + 0.5 * (iso.end - iso.begin), 0, 0});
    leave_unknown(m_.nodes.size() - 1);
    m_.nodes.push_back({iso.end, table_.threshold, level.slope * line.at(iso.end).slope});
    return true;
  }
  /// Adds the nodes between K intervals of one length.
  void add_even_nodes(double begin, double end) {
    const std::size_t first = m_.nodes.size();
    const double h = (end - begin) / settings_.interpolants;
    for (int i = 1; i < settings_.interpolants; ++i) m_.nodes.push_back({begin + h * i, 0, 0});
    leave_unknown(first);
  }

  void add_constant(std::uint32_t item, double from, double to, double value) {
    if (!(from < to)) return;
    begin_field(from, value);
    end_field(item, to, value, std::max(value, 0.0));
  }
  void add_slope(std::uint32_t item, double from, double to, double at_from, double at_to, double most) {
    begin_field(from, at_from);
    add_even_nodes(from, to);
    end_field(item, to, at_to, std::max(most, 0.0));
  }

  void begin_field(double t, double value) {
    PaperMemory::Field field{};
    field.first_node = field.piece = static_cast<std::uint32_t>(m_.nodes.size());
    m_.fields.push_back(field);
    m_.nodes.push_back({t, value, 0});
  }
  /// Marks the field's nodes, from `first` on, as waiting for their values.
  void leave_unknown(std::size_t first) {
    m_.fields.back().first_unknown = static_cast<std::uint32_t>(first);
    m_.fields.back().end_unknown = static_cast<std::uint32_t>(m_.nodes.size());
  }
  void end_field(std::uint32_t item, double t, double value, double peak) {
    PaperMemory::Field& field = m_.fields.back();
    field.item = item;
    field.branch = table_.branch.empty() ? 0 : table_.branch[item];
    field.last_node = static_cast<std::uint32_t>(m_.nodes.size());
    field.peak = peak;
    m_.nodes.push_back({t, value, 0});
    m_.waiting.push_back(static_cast<std::uint32_t>(m_.fields.size() - 1));
  }

  const CompiledBlob& blob_;
  const ComponentTable& table_;
  const SolverSettings& settings_;
  PaperMemory& m_;
  TraceCounters& counters_;
  Vec3 origin_, direction_;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
