// A scene given as text, parsed and evaluated. Most tests of the interpreter begin with it.
#pragma once

#include "grammar/loader.h"
#include "interpreter/evaluate.h"

#include <string>
#include <string_view>

namespace isl::test {

class EvaluatedText {
 public:
  /// A file of the source tree, named from its root.
  struct File {
    std::string path;
  };

  explicit EvaluatedText(std::string_view text, interpreter::EvaluateOptions options = {});
  explicit EvaluatedText(const File& file, interpreter::EvaluateOptions options = {});

  /// The text that #debug wrote.
  [[nodiscard]] const std::string& said() const { return said_; }
  /// All messages, one a line, in order: `error: …`, `warning: …`.
  [[nodiscard]] std::string messages() const;
  [[nodiscard]] const DiagnosticSink& sink() const { return sink_; }
  [[nodiscard]] const scene::Database& database() const { return scene_.database; }
  [[nodiscard]] const interpreter::OriginTable& origins() const { return scene_.origins; }

 private:
  void run(const grammar::Unit* unit, interpreter::EvaluateOptions options);

  grammar::SourceMap sources_;
  grammar::SymbolTable symbols_;
  grammar::Arena arena_;
  DiagnosticSink sink_;
  grammar::Loader loader_;
  std::string said_;
  interpreter::EvaluatedScene scene_;
};

}  // namespace isl::test
