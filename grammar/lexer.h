// Characters → tokens: owns one run of the generated scanner (lexer.ll) over one file. It reports bad characters itself
// and leaves them out, so that the parser sees only tokens. It knows no nesting and no grammar.
#pragma once

#include "base/diagnostic.h"
#include "grammar/arena.h"
#include "grammar/scan_state.h"
#include "grammar/symbols.h"
#include "grammar/token.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string_view>

namespace isl::grammar {

/// Thrown where flex would end the process (out of memory, a token larger than its buffer may grow).
struct ScannerFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Frees flex's tables.
struct CloseScanner {
  void operator()(void* scanner) const;
};

class Lexer {
 public:
  /// `text` starts at the offset `begin` and outlives the tokens. Throws ScannerFailure.
  Lexer(std::string_view text, std::uint32_t begin, SymbolTable& symbols, Arena& arena, DiagnosticSink& sink);
  Lexer(const Lexer&) = delete;  // the scanner points to state_
  Lexer& operator=(const Lexer&) = delete;

  /// The next token; TOK_END_OF_FILE for every call after the end. Throws ScannerFailure.
  [[nodiscard]] Token next();

  /// True if the text ended within a comment or string.
  [[nodiscard]] bool is_cut_off() const { return state_.is_cut_off(); }

 private:
  /// flex counts in int, and its buffer has two bytes more than the text.
  static constexpr std::size_t kMaxTextBytes = 0x7FFFFFFF - 2;

  ScanState state_;
  std::unique_ptr<void, CloseScanner> scanner_;
};

}  // namespace isl::grammar
