#include "cli/options/solver_setting.h"

#include <fmt/format.h>

#include <algorithm>

namespace isl::cli {

std::string SolverSetting::name() const {
  return tolerance ? fmt::format("{} {}", to_text(solver), to_text(*tolerance)) : to_text(solver);
}

std::string SolverSetting::options() const {
  const std::string text = fmt::format("--solver {}", to_text(solver));
  return tolerance ? fmt::format("{} --tolerance {}", text, to_text(*tolerance)) : text;
}

std::string SolverSetting::family() const {
  const std::string text = to_text(solver);
  return text.substr(0, text.find_first_of(":,"));
}

bool SolverSetting::is_default() const {
  return solver == SolverChoice{} && to_text(tolerance.value_or(render::Tolerance{})) == to_text(render::Tolerance{});
}

Parsed<SolverSetting> parse_setting(std::string_view text) {
  const std::size_t blank = std::min(text.find(' '), text.size());
  const auto solver = parse_solver(text.substr(0, blank));
  if (!solver.ok()) return Parsed<SolverSetting>::error(solver.message());
  SolverSetting setting{solver.value(), {}};
  if (blank == text.size()) return setting;
  const auto tolerance = parse_tolerance(text.substr(blank + 1));
  if (!tolerance.ok()) return Parsed<SolverSetting>::error(tolerance.message());
  setting.tolerance = tolerance.value();
  return setting;
}

}  // namespace isl::cli
