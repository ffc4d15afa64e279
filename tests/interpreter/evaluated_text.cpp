#include "tests/interpreter/evaluated_text.h"

#include "tests/support/source_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace isl::test {

EvaluatedText::EvaluatedText(std::string_view text, interpreter::EvaluateOptions options)
    : loader_(sources_, symbols_, arena_, sink_, {}) {
  run(loader_.load_text("scene.isl", std::string(text)), std::move(options));
}

EvaluatedText::EvaluatedText(const File& file, interpreter::EvaluateOptions options)
    : loader_(sources_, symbols_, arena_, sink_, {}) {
  run(loader_.load_scene(std::filesystem::path(ISL_SOURCE_DIR) / file.path), std::move(options));
}

void EvaluatedText::run(const grammar::Unit* unit, interpreter::EvaluateOptions options) {
  if (!unit) {
    ADD_FAILURE() << "there is no text to evaluate";
    return;
  }
  options.print_debug = [this](std::string_view text) { said_ += text; };
  scene_ = interpreter::evaluate(loader_, symbols_, *unit, options, sink_);
}

std::string EvaluatedText::messages() const {
  std::string text;
  for (const Diagnostic& diagnostic : sink_.diagnostics()) {
    text += (diagnostic.severity == Severity::error ? "error: " : "warning: ") + diagnostic.message + "\n";
  }
  return text;
}

}  // namespace isl::test
