#include "cli/accuracy_ladder.h"

#include "cli/render_settings.h"

#include <fmt/format.h>

#include <array>

namespace isl::cli {
namespace {

struct Row {
  const char* solver;
  const char* tolerance;
  const char* family;
};

// clang-format off
/// From the coarsest to the finest, one method after the other.
constexpr std::array kRows{
    Row{"paper:2", "", "paper"},
    Row{"paper:3", "", "paper"},
    Row{"paper:4", "", "paper"},
    Row{"paper:8", "", "paper"},
    Row{"paper:16", "", "paper"},
    Row{"iso", "", "iso"},
    Row{"hermite", "1px", "hermite"},
    Row{"hermite", "0.1px", "hermite"},
    Row{"hermite", "0.05px", "hermite"},
    Row{"hermite", "0.001px", "hermite"},
    Row{"hermite", "1e-6px", "hermite"},
    Row{"hermite", "1e-9px", "hermite"},
    Row{"hermite", "1e-12px", "hermite"},
    Row{"exact", "", "exact"},
};
// clang-format on

bool is_default(const PictureOptions& picture) {
  const SolverChoice solver;
  const render::Tolerance tolerance;
  return to_text(*picture.solver) == to_text(solver) && picture.tolerance &&
         to_text(*picture.tolerance) == to_text(tolerance);
}

/// By the readers of the options themselves, so that a row means what a user gets who writes the same.
Rung rung_of(const Row& row, const AccuracyCommand& command, const scene::Database& database) {
  RenderCommand render;
  render.scene = command.scene;
  render.picture.skeleton = command.skeleton;
  render.picture.solver = parse_solver(row.solver).value();
  if (*row.tolerance != '\0') render.picture.tolerance = parse_tolerance(row.tolerance).value();
  return {row.solver, row.tolerance, row.family, is_default(render.picture), render_settings(render, database).tracer};
}

}  // namespace

std::string Rung::options() const {
  return tolerance.empty() ? fmt::format("--solver {}", solver)
                           : fmt::format("--solver {} --tolerance {}", solver, tolerance);
}

std::string Rung::name() const { return tolerance.empty() ? solver : fmt::format("{} {}", solver, tolerance); }

std::vector<Rung> ladder(const AccuracyCommand& command, const scene::Database& database) {
  std::vector<Rung> rungs;
  for (const Row& row : kRows) rungs.push_back(rung_of(row, command, database));
  return rungs;
}

Rung reference_rung(const AccuracyCommand& command, const scene::Database& database) {
  return rung_of({"exact", "", "exact"}, command, database);
}

}  // namespace isl::cli
