#include "cli/session/diagnostic_printer.h"
#include "grammar/dump.h"
#include "grammar/loader.h"
#include "tests/golden/stages.h"

#include <algorithm>
#include <vector>

namespace isl::test {

StageResult run_parse(const std::filesystem::path& scene) {
  grammar::SourceMap sources;
  grammar::SymbolTable symbols;
  grammar::Arena arena;
  DiagnosticSink sink;
  grammar::Loader loader(sources, symbols, arena, sink, {});
  const grammar::Unit* const unit = loader.load_scene(scene);
  // The complaints of branches and bodies are included, in the order of the text.
  std::vector<const grammar::Complaint*> complaints;
  for (const grammar::Complaint& complaint : loader.complaints()) complaints.push_back(&complaint);
  std::ranges::stable_sort(complaints, {}, [](const auto* complaint) { return complaint->diagnostic.span.begin; });
  for (const grammar::Complaint* complaint : complaints) sink.report(complaint->diagnostic);
  StageResult result{!sink.has_errors(), {}};
  for (const Diagnostic& diagnostic : sink.diagnostics())
    result.text += cli::format_diagnostic(diagnostic, sources, false).text();
  if (result.is_okay && unit != nullptr) result.text += grammar::dump_tree(unit->items, symbols);
  return result;
}

}  // namespace isl::test
