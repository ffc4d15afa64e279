#include "cli/session/report.h"

#include "cli/session/diagnostic_printer.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <cstdlib>
#include <utility>
#include <vector>

namespace isl::cli {

bool wants_colour(std::FILE* stream) {
  const char* const no_colour = std::getenv("NO_COLOR");  // https://no-color.org
  return isatty(fileno(stream)) != 0 && (no_colour == nullptr || *no_colour == '\0');
}

void print_problems(Session& session) {
  const bool colour = wants_colour(stderr);
  for (const Diagnostic& diagnostic : session.sink().diagnostics())
    print(diagnostic, session.sources(), stderr, colour);
}

nlohmann::ordered_json problems_as_json(Session& session) {
  auto problems = nlohmann::ordered_json::array();
  for (const Diagnostic& diagnostic : session.sink().diagnostics())
    problems.emplace_back(to_json(diagnostic, session.sources()));
  return problems;
}

void print_document(const nlohmann::ordered_json& document) {
  // Names of files and texts of scenes may hold any bytes; JSON may not.
  fmt::print("{}\n", document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

void print_error(std::string_view message) { fmt::print(stderr, "isl: error: {}\n", message); }

ExitCode finish(OutputWriter writer) {
  const std::vector<std::string> problems = writer.finish();
  for (const std::string& problem : problems) print_error(problem);
  return problems.empty() ? ExitCode::done : ExitCode::file_error;
}

ExitCode report_failure(Session& session, ExitCode code) {
  if (session.options().format == OutputFormat::json) {
    print_document({{"diagnostics", problems_as_json(session)}});
  } else if (code == ExitCode::interrupted) {
    fmt::print(stderr, "isl: interrupted\n");
  } else {
    print_problems(session);
  }
  return code;
}

}  // namespace isl::cli
