// The settings that `isl accuracy` compares, as a user writes them. Adding one is adding a row.
#pragma once

#include "cli/options.h"
#include "renderer/scene/database.h"
#include "renderer/tracer.h"

#include <string>
#include <vector>

namespace isl::cli {

struct Rung {
  std::string solver;     ///< of --solver
  std::string tolerance;  ///< of --tolerance; "": the solver has none
  std::string family;     ///< what the chart joins by a line
  bool is_default = false;
  render::TracerOptions tracer;

  /// The options that choose it: `--solver hermite --tolerance 0.1px`.
  [[nodiscard]] std::string options() const;
  /// Short, for tables and charts: `hermite 0.1px`.
  [[nodiscard]] std::string name() const;
};

/// Every setting, ready to trace `database` at the command's size. Exactly one is the default.
[[nodiscard]] std::vector<Rung> ladder(const AccuracyCommand& command, const scene::Database& database);

/// What all are measured against.
[[nodiscard]] Rung reference_rung(const AccuracyCommand& command, const scene::Database& database);

}  // namespace isl::cli
