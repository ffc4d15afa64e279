// One parsed text with everything that the result points into: the fixture of this folder's tests.
#pragma once

#include "grammar/dump.h"
#include "grammar/loader.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isl::test {

class ParsedText {
 public:
  explicit ParsedText(std::string text, grammar::LoaderOptions options = {})
      : loader_(sources_, symbols_, arena_, sink_, std::move(options)),
        unit_(loader_.load_text("text", std::move(text))) {}

  [[nodiscard]] grammar::Items items() const { return unit_->items; }
  [[nodiscard]] const grammar::Node& front() const { return *unit_->items.front(); }
  [[nodiscard]] std::string tree() const { return grammar::dump_tree(unit_->items, symbols_); }
  [[nodiscard]] std::string tokens() { return grammar::dump_tokens(sources_, unit_->span, symbols_); }
  [[nodiscard]] std::string_view text(SourceSpan span) const { return sources_.text(span); }
  [[nodiscard]] std::string_view name(grammar::Symbol symbol) const { return symbols_.text(symbol); }
  /// The messages of loading, then the errors of the text that count even if it is not executed.
  [[nodiscard]] std::vector<Diagnostic> diagnostics() const {
    std::vector<Diagnostic> all = sink_.diagnostics();
    for (const grammar::Complaint* complaint : unit_->errors) all.push_back(complaint->diagnostic);
    return all;
  }
  /// The number of errors that count even if the text is not executed.
  [[nodiscard]] std::size_t error_count() const { return sink_.error_count() + unit_->errors.size(); }
  [[nodiscard]] grammar::LoadError last_error() const { return loader_.last_error(); }

 private:
  grammar::SourceMap sources_;
  grammar::SymbolTable symbols_;
  grammar::Arena arena_;
  DiagnosticSink sink_;
  grammar::Loader loader_;
  const grammar::Unit* unit_;
};

}  // namespace isl::test
