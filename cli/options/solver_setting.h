// A setting of the solver to compare with others, as the user names it: a solver and, after a blank, its tolerance, as
// in `hermite 0.1px`, `march:0.2px` or `paper:2,plain`.
#pragma once

#include "cli/options/solver_choice.h"

#include <optional>
#include <string>
#include <string_view>

namespace isl::cli {

struct SolverSetting {
  SolverChoice solver;
  std::optional<render::Tolerance> tolerance;  ///< none: the default's

  /// Short, for tables and charts: `hermite 0.1px`.
  [[nodiscard]] std::string name() const;
  /// The options that choose it: `--solver hermite --tolerance 0.1px`.
  [[nodiscard]] std::string options() const;
  /// The solver's word alone: settings of one family differ in numbers and switches only.
  [[nodiscard]] std::string family() const;
  [[nodiscard]] bool is_default() const;
};

[[nodiscard]] Parsed<SolverSetting> parse_setting(std::string_view text);

}  // namespace isl::cli
