#include "cli/session/diagnostic_printer.h"
#include "grammar/loader.h"
#include "interpreter/evaluate.h"
#include "renderer/scene/dump_json.h"
#include "tests/golden/stages.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace isl::test {
namespace {

/// `line:column`, then the macro calls and includes that led there.
nlohmann::ordered_json describe_origin(const interpreter::Origin& origin, const grammar::SourceMap& sources) {
  const auto place = [&](SourceSpan span) {
    const grammar::SourcePosition position = sources.position(span.begin);
    return fmt::format("{}:{}", position.line, position.column);
  };
  std::string text = place(origin.span);
  for (const ExpansionFrame& frame : origin.chain) text += fmt::format(" < {} {}", frame.name, place(frame.call));
  return text;
}

}  // namespace

StageResult run_eval(const std::filesystem::path& scene) {
  grammar::SourceMap sources;
  grammar::SymbolTable symbols;
  grammar::Arena arena;
  DiagnosticSink sink;
  grammar::Loader loader(sources, symbols, arena, sink, {});
  const grammar::Unit* const unit = loader.load_scene(scene);
  StageResult result{!sink.has_errors(), {}};
  std::string said;
  interpreter::EvaluatedScene evaluated;
  if (unit) {
    interpreter::EvaluateOptions options;
    options.lenient = scene.string().find("_lenient") != std::string::npos;
    options.print_debug = [&](std::string_view text) { said += text; };
    evaluated = interpreter::evaluate(loader, symbols, *unit, options, sink);
  }
  result.is_okay = !sink.has_errors();
  for (const Diagnostic& diagnostic : sink.diagnostics())
    result.text += cli::format_diagnostic(diagnostic, sources, false).text();
  result.text += said;
  if (result.is_okay) {
    result.text += scene::dump_json(
        evaluated.database, [&](OriginId id) { return describe_origin(evaluated.origins.resolve(id), sources); });
  }
  return result;
}

}  // namespace isl::test
