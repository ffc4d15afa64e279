#include "cli/session/report.h"

#include "cli/output/console.h"
#include "cli/output/run_end.h"
#include "cli/session/diagnostic_printer.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <utility>
#include <vector>

namespace isl::cli {

void print_problems(Session& session) {
  const bool colour = wants_colour(Stream::error);
  for (const Diagnostic& diagnostic : session.sink().diagnostics())
    print(Stream::error, format_diagnostic(diagnostic, session.sources(), colour));
}

void report_late(Session& session, Diagnostic problem) {
  if (session.options().format == OutputFormat::text)
    print(Stream::error, format_diagnostic(problem, session.sources(), wants_colour(Stream::error)));
  session.sink().report(std::move(problem));
}

nlohmann::ordered_json problems_as_json(Session& session) {
  auto problems = nlohmann::ordered_json::array();
  for (const Diagnostic& diagnostic : session.sink().diagnostics())
    problems.emplace_back(to_json(diagnostic, session.sources()));
  return problems;
}

void print_document(const nlohmann::ordered_json& document) {
  // Names of files and texts of scenes may hold any bytes; JSON may not.
  print_json(document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

void print_error(std::string_view message) {
  print(Stream::error, fmt::format("isl: error: {}\n", visible_name(message)));
}

ExitCode finish(OutputWriter writer) {
  const std::vector<std::string> problems = writer.finish();
  for (const std::string& problem : problems) print_error(problem);
  return problems.empty() ? ExitCode::done : ExitCode::file_error;
}

ExitCode report_failure(Session& session, ExitCode code) {
  if (session.options().format == OutputFormat::json) {
    print_document({{"diagnostics", problems_as_json(session)}});
  } else if (code == ExitCode::interrupted || code == ExitCode::ended) {
    print(Stream::error, fmt::format("isl: {}\n", text_of(stop_flag().reason())));
  } else {
    print_problems(session);
  }
  return code;
}

ExitCode refuse(Session& session, const scene::Refusal& refusal) {
  const interpreter::Origin origin = session.scene().origins.resolve(refusal.origin);
  report_late(session, {Severity::error, origin.span, refusal.message, refusal.hint, {}, origin.chain});
  if (session.options().format == OutputFormat::json) print_document({{"diagnostics", problems_as_json(session)}});
  return ExitCode::scene_error;
}

}  // namespace isl::cli
