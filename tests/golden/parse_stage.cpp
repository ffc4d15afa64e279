#include "cli/diagnostic_printer.h"
#include "grammar/dump.h"
#include "grammar/loader.h"
#include "tests/golden/stages.h"

namespace isl::test {

StageResult run_parse(const std::filesystem::path& scene) {
  grammar::SourceMap sources;
  grammar::SymbolTable symbols;
  grammar::Arena arena;
  DiagnosticSink sink;
  grammar::Loader loader(sources, symbols, arena, sink, {});
  const grammar::Unit* const unit = loader.load_scene(scene);
  StageResult result{!sink.has_errors(), {}};
  for (const Diagnostic& diagnostic : sink.diagnostics())
    result.text += cli::format_diagnostic(diagnostic, sources, false);
  if (result.is_okay && unit != nullptr) result.text += grammar::dump_tree(unit->items, symbols);
  return result;
}

}  // namespace isl::test
