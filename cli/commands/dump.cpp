// `isl dump`: one stage of the data flow as text. The text is stable, so that golden tests can rely on it.
#include "grammar/dump.h"
#include "cli/commands/commands.h"
#include "cli/options/render_settings.h"
#include "cli/output/console.h"
#include "cli/output/run_end.h"
#include "cli/session/drawable.h"
#include "cli/session/report.h"
#include "renderer/scene/dump_json.h"
#include "renderer/trace/tracer.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace isl::cli {
namespace {

/// `file:line:column` of a primitive's origin; empty if it has no place.
nlohmann::ordered_json place_of(const Session& session, OriginId id) {
  const grammar::SourcePosition place = session.sources().position(session.scene().origins.resolve(id).span.begin);
  if (place.line == 0) return nullptr;
  return fmt::format("{}:{}:{}", place.file, place.line, place.column);
}

std::string database_text(const Session& session) {
  return scene::dump_json(session.scene().database, [&session](OriginId id) { return place_of(session, id); });
}

/// A stage as text, or the reason why there is none.
struct Dump {
  std::string text;
  std::optional<scene::Refusal> refusal;
};

Dump grid_text(const DumpCommand& command, const scene::Database& database, const RunLimits& limits) {
  RenderSettings settings = render_settings({command.scene, {}}, database);
  settings.tracer.run = limits;
  const render::Tracer tracer(database, settings.tracer);
  return {tracer.grid_json() + "\n", tracer.refusal()};
}

/// Precondition: `drawable` is given for the grid.
Dump dump_of(const DumpCommand& command, Session& session, const DrawableScene* drawable) {
  switch (command.stage) {
    case DumpStage::tokens:
      return {grammar::dump_tokens(session.sources(), session.unit().span, session.symbols()), {}};
    case DumpStage::ast: return {grammar::dump_tree(session.unit().items, session.symbols()), {}};
    case DumpStage::database: return {database_text(session), {}};
    case DumpStage::grid: return grid_text(command, drawable->database(), session.limits());
  }
  return {};
}

}  // namespace

ExitCode run(const DumpCommand& command) {
  Session session(command.scene);
  const bool is_text_stage = command.stage == DumpStage::tokens || command.stage == DumpStage::ast;
  const ExitCode code = is_text_stage ? session.load_text() : session.evaluate();
  // The tokens and trees of a text with mistakes are useful, too.
  const bool has_result = code == ExitCode::done || (is_text_stage && code == ExitCode::scene_error);
  if (!has_result) return report_failure(session, code);
  std::optional<DrawableScene> drawable;
  if (command.stage == DumpStage::grid) drawable.emplace(session, PictureOptions().quality);
  if (drawable && drawable->is_refused()) return report_failure(session, ExitCode::scene_error);
  const auto [text, refusal] = dump_of(command, session, drawable ? &*drawable : nullptr);
  if (refusal) return refuse(session, *refusal);
  if (stop_flag().is_set()) return report_failure(session, exit_code_of(stop_flag().reason()));
  if (code == ExitCode::done) {
    if (const ExitCode written = finish(OutputWriter(session.outputs())); written != ExitCode::done) return written;
  }
  if (command.scene.format == OutputFormat::json) {
    print_document({{"diagnostics", problems_as_json(session)}, {"dump", text}});
  } else {
    print_problems(session);
    if (is_text_stage) {
      print_content(Stream::output, text);
    } else {
      print_json(text);
    }
  }
  return code;
}

}  // namespace isl::cli
