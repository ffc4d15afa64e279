// The settings that `isl accuracy` compares. Adding one to those that it takes by itself is adding a row.
#pragma once

#include "cli/options/options.h"
#include "cli/options/solver_setting.h"
#include "renderer/rays/tracer_options.h"
#include "renderer/scene/database.h"

#include <vector>

namespace isl::cli {

struct Rung {
  SolverSetting setting;
  render::TracerOptions tracer;
};

/// The command's settings, or the whole ladder where it names none, ready to trace `database` at the command's size.
/// Exactly one is the default: where it is not named it comes first.
[[nodiscard]] std::vector<Rung> ladder(const AccuracyCommand& command, const scene::Database& database);

/// What all are measured against.
[[nodiscard]] Rung reference_rung(const AccuracyCommand& command, const scene::Database& database);

}  // namespace isl::cli
