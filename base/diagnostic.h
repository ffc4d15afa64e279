// A mistake in the user's scene, as data. cli prints it (through grammar/source_map.h).
#pragma once

#include "base/source_span.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace isl {

enum class Severity { note, warning, error };

/// A second place that explains the first ("opened here", "declared here").
struct DiagnosticNote {
  SourceSpan span;
  std::string message;
};

/// One link of the call chain that led to the span, innermost first.
struct ExpansionFrame {
  enum class Kind { macro, include };
  Kind kind = Kind::macro;
  std::string name;
  SourceSpan call;
};

/// Texts are in lower case, without a full stop, and say what was found.
struct Diagnostic {
  Severity severity = Severity::error;
  SourceSpan span;  ///< empty when no place in the text is at fault
  std::string message;
  std::string hint;  ///< "did you mean `sphere`?", or the remedy
  std::vector<DiagnosticNote> notes;
  std::vector<ExpansionFrame> chain;
};

/// Collects diagnostics in the order in which they arose.
class DiagnosticSink {
 public:
  /// Reading a scene stops after this many errors: more would bury the first ones.
  static constexpr std::size_t kMaxErrors = 20;

  /// Limit of the warnings that are kept: a loop, or a text full of oddities, has millions.
  static constexpr std::size_t kMaxWarnings = 100;

  /// Byte limit of a message or hint; names in a text may be of any length.
  static constexpr std::size_t kMaxTextBytes = 4096;

  void report(Diagnostic diagnostic) {
    cut(diagnostic.message);
    cut(diagnostic.hint);
    if (diagnostic.severity == Severity::error) ++error_count_;
    if (diagnostic.severity == Severity::warning && ++warning_count_ > kMaxWarnings) {
      if (warning_count_ > kMaxWarnings + 1) return;
      diagnostic = {};
      diagnostic.severity = Severity::warning;
      diagnostic.message = std::to_string(kMaxWarnings) + " warnings were shown; further warnings are suppressed";
    }
    diagnostics_.push_back(std::move(diagnostic));
  }
  void error(SourceSpan span, std::string message, std::string hint = {}) {
    report({Severity::error, span, std::move(message), std::move(hint), {}, {}});
  }
  void warning(SourceSpan span, std::string message, std::string hint = {}) {
    report({Severity::warning, span, std::move(message), std::move(hint), {}, {}});
  }

  [[nodiscard]] bool has_errors() const { return error_count_ > 0; }
  [[nodiscard]] bool is_full() const { return error_count_ >= kMaxErrors; }
  [[nodiscard]] bool is_full_of_warnings() const { return warning_count_ > kMaxWarnings; }
  [[nodiscard]] std::size_t error_count() const { return error_count_; }
  [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  static void cut(std::string& text) {
    if (text.size() <= kMaxTextBytes) return;
    std::size_t end = kMaxTextBytes;
    // never splits a UTF-8 character
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;
    text.resize(end);
    text += "…";
  }

  std::vector<Diagnostic> diagnostics_;
  std::size_t error_count_ = 0;
  std::size_t warning_count_ = 0;
};

}  // namespace isl
