#include "cli/accuracy/ladder.h"

#include "cli/options/render_settings.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace isl::cli {
namespace {

// clang-format off
/// From the coarsest to the finest, one method after the other.
constexpr std::array<std::string_view, 30> kRows{
    "paper:2",
    "paper:3",
    "paper:4",
    "paper:8",
    "paper:16",
    "iso",
    "march:1px",
    "march:0.2px",
    "march:0.05px",
    "climb:1px",
    "climb:0.2px",
    "climb:0.05px",
    "sphere",
    "sphere:1.5",
    "sphere 1e-6px",
    "segment",
    "segment 1e-6px",
    "lg",
    "lg:octree",
    "interval",
    "inclusion",
    "hermite:single",
    "hermite:digits",
    "hermite 1px",
    "hermite 0.05px",
    "hermite 0.001px",
    "hermite 1e-6px",
    "hermite 1e-9px",
    "hermite 1e-12px",
    "exact",
};
// clang-format on

/// Uses the readers of the options themselves, so that a row means the same as a user's options.
Rung rung_of(const SolverSetting& setting, const AccuracyCommand& command, const scene::Database& database) {
  RenderCommand render;
  render.scene = command.scene;
  render.picture.unblended = command.unblended;
  render.picture.solver = setting.solver;
  render.picture.tolerance = setting.tolerance;
  return {setting, render_settings(render, database).tracer};
}

std::vector<SolverSetting> whole_ladder() {
  std::vector<SolverSetting> settings;
  for (const std::string_view row : kRows) settings.push_back(parse_setting(row).value());
  return settings;
}

}  // namespace

std::vector<Rung> ladder(const AccuracyCommand& command, const scene::Database& database) {
  std::vector<SolverSetting> settings = command.settings.empty() ? whole_ladder() : command.settings;
  if (std::ranges::none_of(settings, &SolverSetting::is_default)) settings.insert(settings.begin(), SolverSetting{});
  std::vector<Rung> rungs;
  for (const SolverSetting& setting : settings) rungs.push_back(rung_of(setting, command, database));
  return rungs;
}

Rung exact_rung(const AccuracyCommand& command, const scene::Database& database) {
  return rung_of(parse_setting("exact").value(), command, database);
}

}  // namespace isl::cli
