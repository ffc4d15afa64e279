// The settings that `isl accuracy` compares. A new default setting is a new row.
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

/// The command's settings, or the whole ladder if it names none, ready to trace `database` at the command's size.
/// Exactly one is the default: if it is not named it is added first.
[[nodiscard]] std::vector<Rung> ladder(const AccuracyCommand& command, const scene::Database& database);

/// The exact solver's setting.
[[nodiscard]] Rung exact_rung(const AccuracyCommand& command, const scene::Database& database);

}  // namespace isl::cli
