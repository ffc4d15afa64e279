#include "tests/fuzz/hostile_text.h"

#include "grammar/loader.h"
#include "interpreter/evaluate.h"
#include "renderer/queries/object_queries.h"

#include <unistd.h>
#include <csignal>
#include <cstdlib>
#include <initializer_list>
#include <mutex>

// The sanitizers' runtime defines this function; without them it is null.
extern "C" [[gnu::weak]] void __sanitizer_set_death_callback(void (*callback)());

namespace isl::test {
namespace {

std::string current_text;

/// Calls only functions that a signal handler may call.
void print_current_text() {
  static constexpr std::string_view kBefore = "\nThe text that was evaluated:\n", kAfter = "\n(end of the text)\n";
  for (const std::string_view part : {kBefore, std::string_view(current_text), kAfter}) {
    if (write(STDERR_FILENO, part.data(), part.size()) < 0) return;
  }
}

void print_and_die(int signal_number) {
  print_current_text();
  std::signal(signal_number, SIG_DFL);
  std::raise(signal_number);
}

void install_handlers() {
  if (__sanitizer_set_death_callback != nullptr) {
    __sanitizer_set_death_callback(print_current_text);
    std::signal(SIGABRT, print_and_die);
    return;
  }
  for (const int number : {SIGABRT, SIGSEGV, SIGFPE, SIGBUS, SIGILL}) std::signal(number, print_and_die);
}

/// The limits are small, because thousands of texts are evaluated and some of them are endless loops.
interpreter::EvaluateOptions short_options() {
  interpreter::EvaluateOptions options;
  options.lenient = true;  // skips what is not supported and writes files in memory, so that more of the text is read
  options.limits = {.max_depth = 60,
                    .max_turns = 3000,
                    .max_primitives = 3000,
                    .max_memory_bytes = std::size_t{64} << 20,
                    .max_include_depth = 5};
  return options;
}

}  // namespace

void remember_for_crash(std::string_view text) {
  static std::once_flag once;
  std::call_once(once, install_handlers);
  current_text = text;
}

Verdict evaluate_hostile(std::string_view text) {
  remember_for_crash(text);
  grammar::SourceMap sources;
  grammar::SymbolTable symbols;
  grammar::Arena arena;
  DiagnosticSink sink;
  grammar::Loader loader(sources, symbols, arena, sink, {});
  const grammar::Unit* const unit = loader.load_text("scene.isl", std::string(text));
  if (!unit) return {true, "the text was not read at all"};
  interpreter::EvaluateOptions options = short_options();
  render::ObjectQueries queries;
  options.queries = &queries;
  const interpreter::EvaluatedScene scene = interpreter::evaluate(loader, symbols, *unit, options, sink);
  Verdict verdict{sink.has_errors(), {}};
  for (const Diagnostic& diagnostic : sink.diagnostics()) {
    const bool has_place = sources.position(diagnostic.span.begin).line != 0;
    if (diagnostic.severity == Severity::error && !has_place)
      verdict.trouble += "an error without a place: " + diagnostic.message + "\n";
    if (diagnostic.message.empty()) verdict.trouble += "an empty message\n";
  }
  return verdict;
}

void StatementBatch::add(std::string_view statement) {
  statements_ += statement;
  statements_ += '\n';
  ++count_;
  // A statement may have two errors.
  if (++waiting_ == DiagnosticSink::kMaxErrors / 2) flush();
}

void StatementBatch::flush() {
  if (waiting_ == 0) return;
  const std::string text = prelude_ + statements_;
  const Verdict verdict = evaluate_hostile(text);
  if (!verdict.trouble.empty()) troubles_.push_back(verdict.trouble + "in:\n" + statements_);
  statements_.clear();
  waiting_ = 0;
}

}  // namespace isl::test
