// The solver as the user names it: `hermite`, `paper:4`, `paper,no-reject,eq10`. Converts text to a choice or an error,
// and back; serves the command line and `global_settings`.
#pragma once

#include "cli/options/option_values.h"
#include "renderer/rays/tracer_options.h"

#include <string>
#include <string_view>

namespace isl::cli {

struct SolverChoice {
  render::SolverName name = render::SolverName::hermite;
  int interpolants = 2;             ///< of `paper:K`
  render::PaperSwitches paper;      ///< of `paper` and `iso`
  render::Tolerance step{1, true};  ///< of `march:STEP` and `climb:STEP`
  double relaxation = 1;            ///< of `sphere:OMEGA`
  bool octree = false;              ///< of `lg:octree`
  bool single = false;              ///< of `hermite:single` and `exact:single`: rays one by one
  bool digits = false;              ///< of `hermite:digits` and `exact:digits`: so, and crossings with more digits

  friend bool operator==(const SolverChoice&, const SolverChoice&) = default;
};

/// A name, for some solvers a number after a colon, and for `paper` and `iso` any number of switches after commas:
/// those of render::kPaperSwitches, of which a later one wins, and `plain`, which turns all off.
[[nodiscard]] Parsed<SolverChoice> parse_solver(std::string_view text);

/// The reverse, as the user would write it: only the switches that differ from the solver's own, or after `plain` those
/// that are on, whichever are fewer.
[[nodiscard]] std::string to_text(const SolverChoice& solver);

/// The solvers and their arguments after the colon, as a list for help texts.
[[nodiscard]] std::string solvers_text();

/// The switches, as a list for help texts.
[[nodiscard]] std::string solver_switches_text();

}  // namespace isl::cli
