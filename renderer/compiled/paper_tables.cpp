#include "renderer/compiled/paper_tables.h"

#include <map>

namespace isl::render {
namespace {

/// The argument v at which amplitude · φ passes the threshold, bisected to neighbouring doubles. φ falls with v.
IsoLevel iso_level(const KernelConstants& kernel, double amplitude, double threshold) {
  if (!(amplitude * kernel_profile(kernel, 0) > threshold)) return {};
  double inside = 0, outside = kernel.support;
  for (double middle = 0.5 * outside; middle > inside && middle < outside; middle = inside + 0.5 * (outside - inside)) {
    (amplitude * kernel_profile(kernel, middle) > threshold ? inside : outside) = middle;
  }
  return {inside, amplitude * kernel_slope(kernel, inside)};
}

}  // namespace

PaperTables make_paper_tables(const ComponentTable& table, bool iso) {
  PaperTables tables;
  if (iso) tables.iso.resize(table.size());
  for (const FieldGroup& group : table.groups) {
    auto& profile = tables.profiles.emplace_back();
    if (group.kernel.is_convolved) continue;
    for (int i = 0; i < PaperTables::kSteps; ++i) {
      profile[static_cast<std::size_t>(i)] =
          kernel_profile(group.kernel, group.kernel.support * i / PaperTables::kSteps);
    }
    if (!iso || scene::is_endless(group.skeleton)) continue;
    std::map<double, IsoLevel> known;  // components of a group have few different strengths
    for (std::uint32_t item = group.begin; item < group.end; ++item) {
      const auto [level, is_new] = known.try_emplace(table.amplitude[item]);
      if (is_new) level->second = iso_level(group.kernel, table.amplitude[item], table.threshold);
      tables.iso[item] = level->second;
    }
  }
  return tables;
}

}  // namespace isl::render
