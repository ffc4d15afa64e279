#include "renderer/compiled/paper_tables.h"

#include <map>
#include <optional>

namespace isl::render {
namespace {

IsoLevel iso_level(const KernelConstants& kernel, double amplitude, double threshold) {
  const std::optional<double> v = passing_argument(kernel, amplitude, threshold);
  return v ? IsoLevel{*v, amplitude * kernel_slope(kernel, *v)} : IsoLevel{};
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
